"""The pages that `asts report` writes of real runs, in headless Chromium: a small campaign that finds a violation, one
of all claims, and a check of a refined sphere and of a published mesh. Every mesh shown is driven and compared with
its JSON.

report_test.py ASTS CASES: the program, and the folder tests/cases.
"""

import os
import subprocess
import sys
import unittest
from fractions import Fraction

from page_checks import check_everywhere, check_structure
from page_data import AXES
from page_test_case import PageTestCase
from view_checks import check_camera, check_picked, check_slice
from view_driver import View

ASTS, CASES = "", ""


def asts(*words, codes=(0,)):
    """Runs the program, which must end with one of these exit codes."""
    run = subprocess.run([ASTS, *words], capture_output=True, check=False)
    if run.returncode not in codes:
        raise RuntimeError(f"asts {' '.join(words)}: exit code {run.returncode}\n{run.stderr.decode()}")
    return run.stdout


class ReportPage:
    """A page of a run directory that `make_run` fills; least_* say that the run has what is to be looked at."""

    @classmethod
    def make_page(cls):
        run = os.path.join(cls.folder, "run")
        cls.make_run(run)
        asts("report", run, "-o", cls.path)

    def test_nothing_is_outside_and_nothing_complains(self):
        check_everywhere(self, self.page, self.path)

    def test_headings_tables_and_pictures_are_real(self):
        self.open(width=800)
        check_structure(self, self.page)

    def test_every_mesh_is_shown_as_it_is(self):
        self.assertGreaterEqual(len(self.meshes), self.least_meshes)
        self.open()
        pairs = 0
        for figure, mesh in self.meshes.items():
            with self.subTest(figure=figure):
                pairs += self.drive(View(self.page, figure), mesh)
        self.assertGreaterEqual(pairs, self.least_pairs)

    def drive(self, view, mesh):
        """Turn, slice, pick; returns whether there was something violated to pick."""
        check_camera(self, view, mesh)
        view.press_on("canvas", "ArrowRight", "ArrowDown")
        check_camera(self, view, mesh)
        for axis in range(3):
            view.choose_axis(AXES[axis])
            check_slice(self, view, mesh, axis, Fraction(view.slice_position))
            view.press_on("canvas", "PageUp")
            check_slice(self, view, mesh, axis, Fraction(view.slice_position))
        if mesh.nodes:
            view.press_on("canvas", "n")
            check_picked(self, view, mesh, [0])
        names = mesh.json["marks"]["nodes"]
        if not names:
            return 0
        view.click_on(".mesh-view-witness")
        check_picked(self, view, mesh, [node["node"] for node in names])
        return 1


class CampaignReport(ReportPage, PageTestCase):
    least_meshes, least_pairs = 1, 1

    @classmethod
    def make_run(cls, run):
        asts("campaign", "--claim", "as-implies-dc", "--cases", "128", "--seed", "1", "--out", run, codes=(1,))


class ReportOfAllClaims(ReportPage, PageTestCase):
    """The widest tables, and findings of every kind."""

    least_meshes, least_pairs = 9, 3

    @classmethod
    def make_run(cls, run):
        asts("campaign", "--cases", "64", "--seed", "1", "--out", run, codes=(3,))  # too few cases: bad health


class CheckReport(ReportPage, PageTestCase):
    least_meshes, least_pairs = 2, 1

    @classmethod
    def make_run(cls, run):
        sphere = os.path.join(cls.folder, "sphere.case")
        with open(sphere, "wb") as file:
            file.write(asts("generate", "sphere", "--domain", "8,8,8", "--elements", "1500"))
        asts("check", "--final", "--out", run, sphere, os.path.join(CASES, "planar", "published-bad-tmesh.case"),
             codes=(1,))


if __name__ == "__main__":
    ASTS, CASES = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
