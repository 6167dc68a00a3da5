"""The interactive view of a mesh with 10^5 elements: opening the page and each interaction work, and show what the JSON
says. Prints how long frames take; only the waiting is capped, at 5 s each.

large_test.py ASTS MAKE_VIEW_PAGE
"""

import os
import subprocess
import sys
import time
import unittest
from fractions import Fraction

from page_data import AXES
from page_test_case import PageTestCase
from view_driver import View, expected_faces

ASTS, MAKE_VIEW_PAGE = "", ""
ELEMENTS = 100_000


class Large(PageTestCase):
    @classmethod
    def make_page(cls):
        case = os.path.join(cls.folder, "sphere.case")
        with open(case, "w", encoding="utf-8") as file:
            subprocess.run([ASTS, "generate", "sphere", "--domain", "16,16,16", "--elements", str(ELEMENTS)],
                           stdout=file, check=True)
        with open(cls.path, "w", encoding="utf-8") as file:
            subprocess.run([MAKE_VIEW_PAGE, case, "-"], stdout=file, check=True)

    def timed(self, what, act):
        begin = time.monotonic()
        act()
        print(f"{what}: {1000 * (time.monotonic() - begin):.0f} ms with the browser's way, of these "
              f"{self.view.frame_ms} ms drawing {self.view.drawn} faces", flush=True)

    def check(self):
        axis, place = AXES.index(self.view.slice_axis), Fraction(self.view.slice_position)
        self.assertEqual(self.view.slice_elements, str(len(self.mesh.cut(axis, place)[0])))
        self.assertEqual(self.view.drawn, str(expected_faces(self.mesh, axis, place, self.view.towards())))

    def test_everything_works(self):
        self.mesh = self.meshes["view-1"]
        self.assertGreaterEqual(len(self.mesh.elements), ELEMENTS)
        self.view = view = View(self.page, "view-1")
        self.timed("opening", lambda: self.page.open(self.path))
        self.check()
        self.timed("turning", lambda: view.press_on("canvas", "ArrowRight"))
        self.check()
        self.timed("dragging", lambda: self.page.drag(*self.page.centre_of(view.canvas), 200, 100))
        self.check()
        self.timed("another axis", lambda: view.choose_axis("x"))
        self.check()
        self.timed("moving the slice", lambda: view.press_on(".mesh-view-slider", "ArrowRight"))
        self.check()
        self.timed("the next node", lambda: view.click_on("[title='Next node']"))
        self.assertEqual(view.picked_node, "0")
        self.timed("facing the slice", lambda: view.click_on(".mesh-view-face"))
        self.check()
        self.timed("all nodes", lambda: view.show(allNodes=True))
        last = len(self.mesh.nodes) - 1
        self.timed("the last node", lambda: view.press_on("canvas", "p"))
        self.assertEqual(view.picked_node, str(last))
        self.timed("a click", lambda: view.click_at(self.mesh.nodes[last][0]))
        self.timed("the skeleton", lambda: view.show(skeleton=True))
        self.check()


if __name__ == "__main__":
    ASTS, MAKE_VIEW_PAGE = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
