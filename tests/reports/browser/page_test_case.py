"""What the tests of a page share: one page, opened in one browser for all tests of a class."""

import os
import tempfile
import unittest

from browser import Browser, Page
from page_data import meshes_of
from view_driver import View


class PageTestCase(unittest.TestCase):
    """`make_page` writes the page to cls.path, in the fresh folder cls.folder; cls.meshes are those that it shows."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.path = os.path.join(cls.folder, "page.html")
        cls.make_page()
        cls.meshes = meshes_of(cls.path)
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)
        cls.page = Page(cls.browser, 1400)

    def open(self, width=1400):
        self.page.media("screen")
        self.page.resize(width)
        self.page.open(self.path)

    def open_view(self, figure="view-1"):
        """Opens the page; returns the view and what the page's JSON says of its mesh."""
        self.open()
        return View(self.page, figure), self.meshes[figure]

    def tearDown(self):
        self.assertEqual((self.page.problems(), self.page.requests()), ([], []))
