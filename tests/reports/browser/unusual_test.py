"""Interactive views of meshes at the limits: very deep ones, without active nodes, without some index vector, without a
line where the active region ends, with levels that are no integers.

unusual_test.py MAKE_VIEW_PAGE
"""

import math
import os
import subprocess
import sys
import unittest
from fractions import Fraction

from page_checks import check_everywhere
from page_data import AXES
from page_test_case import PageTestCase
from view_checks import check_camera, check_picked, check_slice

MAKE_VIEW_PAGE = ""
HEAD = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain "
HALVES = [f"{x} {y} {z}  {x + 2} {y + 2} {z + 2}" for x in (0, 2) for y in (0, 2) for z in (0, 2)]
CASES = {
    "deep": HEAD + "4 4 4\n" + "subdivide 0 0 0\n" * 330,  # a corner of 2^-110 units
    "small": HEAD + "4 4 3\n",
    "one box": HEAD + "4 4 4\nelement 0 0 0  4 4 4\n",
    "no vectors": HEAD + "4 4 4\n" + "".join(f"element {box}\n" for box in HALVES),
    "no level": HEAD + "4 4 4\nelement 0 0 0  1 4 4\nelement 1 0 0  4 4 4\n",
}


class Unusual(PageTestCase):
    @classmethod
    def make_page(cls):
        words = []
        for name, text in CASES.items():
            words += [os.path.join(cls.folder, f"{name}.case"), "-"]
            with open(words[-2], "w", encoding="utf-8") as file:
                file.write(text)
        with open(cls.path, "w", encoding="utf-8") as file:
            subprocess.run([MAKE_VIEW_PAGE, *words], stdout=file, check=True)

    def view(self, name):
        return self.open_view(f"view-{list(CASES).index(name) + 1}")

    def test_nothing_is_outside_and_nothing_complains(self):
        check_everywhere(self, self.page, self.path)

    def test_slices_and_cameras(self):
        for name in CASES:
            view, mesh = self.view(name)
            with self.subTest(name):
                for axis in range(3):
                    view.choose_axis(AXES[axis])
                    for key in ("Home", "ArrowRight", "ArrowRight"):
                        view.press_on(".mesh-view-slider", key)
                        if name != "deep":  # whose faces are too thin to count: they have no width as pixels
                            check_camera(self, view, mesh)
                            check_slice(self, view, mesh, axis, Fraction(view.slice_position))
                        self.assertEqual(view.slice_elements,
                                         str(len(mesh.cut(axis, Fraction(view.slice_position))[0])))

    def test_depth_is_exact(self):
        view, mesh = self.view("deep")
        view.choose_axis("x")
        view.press_on(".mesh-view-slider", "Home", "ArrowRight")
        self.assertEqual(view.slice_position, f"1/{2 ** 111}", "half of 2^-110")
        view.press_on("canvas", "n")
        check_picked(self, view, mesh, [0])
        view.click_on(".mesh-view-near")
        self.assertTrue(all(map(math.isfinite, view.numbers("units") + view.numbers("origin"))))

    def test_what_there_is_not_is_said(self):
        view, _ = self.view("small")
        self.assertEqual(view.texts('[title="Next node"]'), [])
        self.assertIn("There is none.", view.text(".mesh-view-panel"))
        view, mesh = self.view("no vectors")
        self.assertEqual(mesh.nodes, [((2, 2, 2), None)])
        view.press_on("canvas", "n")
        self.assertEqual(view.picked_node, "0")
        self.assertEqual(view.texts("[data-vector]"), [f"index vector along {axis}: not known" for axis in AXES])
        view, _ = self.view("one box")
        self.assertEqual(view.texts("li[data-level]"), ["level -6: 1 element"])
        view, _ = self.view("no level")
        self.assertEqual(view.texts("li[data-level]"), ["level none: 1 element", "level -4: 1 element"])


if __name__ == "__main__":
    MAKE_VIEW_PAGE = sys.argv[1]
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
