"""Drives the interactive view of a mesh in headless Chromium and compares what it shows with the page's JSON.

view_test.py MAKE_VIEW_PAGE FINDINGS: the program that prints pages, and the folder of findings.
"""

import os
import subprocess
import sys
import unittest
from fractions import Fraction

from page_checks import check_everywhere
from page_data import AXES, exact
from page_test_case import PageTestCase
from view_checks import check_camera, check_picked, check_slice

MAKE_VIEW_PAGE, FINDINGS = "", ""


class OnePage(PageTestCase):
    """A page with three meshes: a violated pair, regions that meet, none of them."""

    @classmethod
    def make_page(cls):
        finding = lambda name: os.path.join(FINDINGS, name)
        with open(cls.path, "w", encoding="utf-8") as file:
            subprocess.run([MAKE_VIEW_PAGE, finding("as-implies-dc.case"), "dual-compatible",
                            finding("dc-implies-as.case"), "dc-implies-as", finding("as-implies-dc.case"), "-"],
                           stdout=file, check=True)


class Layout(OnePage):
    def test_nothing_is_outside_and_nothing_complains(self):
        check_everywhere(self, self.page, self.path)

    def test_print_shows_the_static_picture(self):
        self.open()
        shown = "(s) => getComputedStyle(document.querySelector('#view-1 > ' + s)).display"
        visible = lambda part: self.page.evaluate(f"({shown})('{part}')") != "none"
        self.assertEqual((visible("svg"), visible(".mesh-view-live")), (False, True))
        self.page.media("print")
        self.assertEqual((visible("svg"), visible(".mesh-view-live")), (True, False))

    def test_a_page_without_scripts_shows_the_static_picture(self):
        self.page.call("Emulation.setScriptExecutionDisabled", value=True)
        try:
            self.page.load(self.path)
            document = self.page.call("DOM.getDocument")["root"]["nodeId"]
            svg = self.page.call("DOM.querySelector", nodeId=document, selector="#view-1 > svg")["nodeId"]
            self.assertGreater(self.page.call("DOM.getBoxModel", nodeId=svg)["model"]["width"], 100)
        finally:
            self.page.call("Emulation.setScriptExecutionDisabled", value=False)

    def test_every_control_has_a_name_and_the_tab_key_reaches_them(self):
        view, _ = self.open_view()
        unnamed = self.page.evaluate("""[...document.querySelectorAll('#view-1 button, #view-1 input')].filter(e =>
            !(e.getAttribute('aria-label') || e.textContent || e.closest('label')?.textContent)).length""")
        self.assertEqual(unnamed, 0)
        self.page.evaluate("document.querySelector('#view-1 canvas').focus()")
        reached = set()
        for _ in range(30):
            self.page.press("Tab")
            reached.add(self.page.evaluate("document.activeElement.className || document.activeElement.type"))
        self.assertLessEqual({"radio", "mesh-view-slider", "mesh-view-face", "mesh-view-number", "mesh-view-witness",
                              "checkbox"}, reached)
        self.assertEqual(self.page.evaluate("document.querySelector('#view-1 .mesh-view-says').ariaLive"), "polite")


class Slice(OnePage):
    def test_the_slider_moves_through_every_line_and_every_gap(self):
        for figure in ("view-1", "view-2"):
            view, mesh = self.open_view(figure)
            for axis in range(3):
                view.choose_axis(AXES[axis])
                view.press_on(".mesh-view-slider", "Home")
                lines = mesh.lines[axis]
                places = [lines[0]]
                for low, high in zip(lines, lines[1:]):
                    places += [(low + high) / 2, high]
                for index, place in enumerate(places):
                    with self.subTest(figure=figure, axis=AXES[axis], place=exact(place)):
                        self.assertEqual(view.slice_index, str(index))
                        check_slice(self, view, mesh, axis, place)
                    view.press_on(".mesh-view-slider", "ArrowRight")
                self.assertEqual(view.slice_index, str(len(places) - 1), "the slider ends at the last line")

    def test_elements_have_the_colour_of_their_level(self):
        view, mesh = self.open_view()
        view.show(nodes=False, regions=False, active=False)
        legend = view.legend_colours()
        self.assertEqual(sorted(legend), sorted({element[2] for element in mesh.elements}))
        self.assertEqual(len({tuple(colour) for colour in legend.values()}), len(legend))
        checked = 0
        for axis in range(3):
            view.choose_axis(AXES[axis])
            view.click_on(".mesh-view-face")
            for _ in range(2):
                place = Fraction(view.slice_position)
                elements = mesh.seen_in(axis, place, view.towards()[axis] > 0)
                inside = [[low + (high - low) * Fraction(3, 10) for low, high in zip(e[0], e[1])] for e in elements]
                for point in inside:
                    point[axis] = place
                colours = view.colours_at([view.on_canvas(point) for point in inside])
                self.assertEqual(colours, [legend[element[2]] for element in elements])
                checked += len(elements)
                view.press_on("canvas", "PageDown")
        self.assertGreater(checked, 80)


class Turn(OnePage):
    def test_keys_and_dragging_turn_it(self):
        view, mesh = self.open_view()
        check_camera(self, view, mesh)
        yaw, image = float(view.yaw), view.image()
        view.press_on("canvas", "ArrowRight", "ArrowRight", "ArrowUp")
        self.assertEqual((float(view.yaw), float(view.pitch)), (yaw + 10, 30))
        self.assertNotEqual(view.image(), image)
        check_camera(self, view, mesh)
        self.page.drag(*self.page.centre_of(view.canvas), -300, 20)
        self.assertGreater(abs(float(view.yaw) - yaw - 10), 60)
        check_camera(self, view, mesh)
        for _ in range(5):
            self.page.drag(*self.page.centre_of(view.canvas), -150, -60)
            check_camera(self, view, mesh)
        view.press_on("canvas", "Home")
        self.assertEqual((float(view.yaw), float(view.pitch)), (yaw, 25))
        self.assertEqual(view.image(), image, "the same state, the same picture")

    def test_buttons_turn_and_zoom(self):
        view, mesh = self.open_view()
        before = check_camera(self, view, mesh)
        view.click_on("[title='Zoom in']")
        self.assertAlmostEqual(check_camera(self, view, mesh), 1.25 * before, places=6)
        view.click_on("[title='Turn to the left']")
        self.assertEqual(float(view.yaw), -75)
        view.click_on("[title='Turn up']")
        self.assertEqual(float(view.pitch), 40)
        view.click_on(".mesh-view-reset")
        self.assertAlmostEqual(check_camera(self, view, mesh), before, places=6)


class Pick(OnePage):
    def test_a_click_picks_the_node_that_is_drawn_there(self):
        for figure in ("view-1", "view-2"):
            view, mesh = self.open_view(figure)
            for axis in range(3):
                view.choose_axis(AXES[axis])
                view.click_on(".mesh-view-face")
                place = Fraction(view.slice_position)
                for node, (point, _) in enumerate(mesh.nodes):
                    if point[axis] != place:
                        continue
                    view.click_on(".mesh-view-none")
                    self.assertEqual(view.picked_node, "")
                    view.click_at(point)
                    check_picked(self, view, mesh, [node])

    def test_buttons_keys_and_the_number_pick(self):
        view, mesh = self.open_view("view-2")
        view.click_on("[title='Next node']")
        check_picked(self, view, mesh, [0])
        view.press_on("canvas", "n", "n")
        check_picked(self, view, mesh, [2])
        self.assertEqual(Fraction(view.slice_position), mesh.nodes[2][0][AXES.index(view.slice_axis)],
                         "the slice follows")
        view.press_on("canvas", "p", "p", "p")
        check_picked(self, view, mesh, [len(mesh.nodes) - 1])
        self.page.evaluate("""(() => { const e = document.querySelector('#view-2 .mesh-view-number');
            e.value = 4; e.dispatchEvent(new Event('change')); })()""")
        self.page.settle()
        check_picked(self, view, mesh, [3])

    def test_a_picked_node_is_drawn_with_its_support(self):
        view, mesh = self.open_view()
        view.click_on("[title='Next node']")
        view.click_on(".mesh-view-face")
        with_node = view.image()
        low, high = zip(*mesh.support(0))
        corners = [view.on_canvas((low[0], low[1], 0)), view.on_canvas((high[0], high[1], 0))]
        middle = [(corners[0][0] * 0.9 + corners[1][0] * 0.1), corners[0][1]]  # on the lower edge, off every tick
        self.assertEqual(view.colours_at([middle]), [[204, 121, 167]], "the first node's colour, on the support's edge")
        view.click_on(".mesh-view-none")
        self.assertNotEqual(view.image(), with_node)
        self.assertNotEqual(view.colours_at([middle]), [[204, 121, 167]])

    def test_zooming_to_it_fills_the_canvas_with_the_support(self):
        view, mesh = self.open_view()
        view.click_on("[title='Next node']")
        view.click_on(".mesh-view-near")
        low, high = zip(*mesh.support(0))
        middle = view.on_canvas([(a + b) / 2 for a, b in zip(low, high)])
        size = self.page.evaluate(f"(c => [c.clientWidth, c.clientHeight])(document.querySelector('{view.canvas}'))")
        self.assertAlmostEqual(middle[0], size[0] / 2, places=6)
        self.assertAlmostEqual(middle[1], size[1] / 2, places=6)

    def test_one_button_picks_the_violated_pair(self):
        for figure in ("view-1", "view-2"):
            view, mesh = self.open_view(figure)
            self.assertEqual(view.picked_node, "")
            view.click_on(".mesh-view-witness")
            names = mesh.json["marks"]["nodes"]
            self.assertGreaterEqual(len(names), 2)
            self.assertEqual(sorted(node["node"] for node in names), sorted(mesh.json["picked"]))
            check_picked(self, view, mesh, [node["node"] for node in names])
            self.assertEqual(view.texts(".mesh-view-node strong"), [node["name"] for node in names])
            self.assertIn(mesh.json["says"], view.text(".mesh-view-says"))
            for point in mesh.json["marks"]["points"]:
                self.assertIn("(" + ", ".join(point["at"]) + ")", view.text(".mesh-view-says"))
        view, _ = self.open_view("view-3")
        self.assertEqual(view.texts(".mesh-view-witness"), [], "nothing is violated: no button")

    def test_perturbed_regions_have_their_colours_where_they_are(self):
        view, mesh = self.open_view("view-2")
        view.show(nodes=False, active=False)
        view.choose_axis("x")
        regions = mesh.json["regions"]
        box = regions[0][0]
        places = [mesh.lines[i // 2][place] if isinstance(place, int) else Fraction(place)
                  for i, place in enumerate(box)]
        view.press_on(".mesh-view-slider", "Home", *["ArrowRight"] * (2 * mesh.lines[0].index(places[0])))
        self.assertEqual(Fraction(view.slice_position), places[0])
        view.click_on(".mesh-view-face")
        inside = view.on_canvas((places[0], places[2] + (places[3] - places[2]) * Fraction(3, 10),
                                 places[4] + (places[5] - places[4]) * Fraction(3, 10)))
        [with_region] = view.colours_at([inside])
        view.show(regions=False)
        [without] = view.colours_at([inside])
        for channel, full in enumerate((213, 94, 0)):
            self.assertAlmostEqual(with_region[channel], (without[channel] + full) / 2, delta=2)


if __name__ == "__main__":
    MAKE_VIEW_PAGE, FINDINGS = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
