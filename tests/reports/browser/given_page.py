"""Does with a page that is there already, for instance that of `./build.sh verify`, what report_test.py does with small
ones:

given_page.py PAGE
"""

import sys
import unittest

from page_test_case import PageTestCase
from report_test import ReportPage

PAGE = ""


class GivenPage(ReportPage, PageTestCase):
    least_meshes, least_pairs = 1, 0

    @classmethod
    def make_page(cls):
        cls.path = PAGE

    def test_every_mesh_is_shown_as_it_is(self):
        super().test_every_mesh_is_shown_as_it_is()
        print(f"{len(self.meshes)} meshes", flush=True)


if __name__ == "__main__":
    PAGE = sys.argv[1]
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
