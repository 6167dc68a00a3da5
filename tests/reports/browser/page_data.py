"""Reads a report's HTML file without a browser: its meshes, decoded as reports/html/mesh_view.hpp describes them."""

import base64
import html.parser
import json
import struct
from fractions import Fraction

AXES = "xyz"


class _Figures(html.parser.HTMLParser):
    """Collects the JSON of every figure.mesh-view, by the figure's id."""

    def __init__(self):
        super().__init__()
        self.meshes = {}
        self.figure = None
        self.reading = False

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        classes = (attributes.get("class") or "").split()
        if tag == "figure" and "mesh-view" in classes:
            self.figure = attributes["id"]
        if tag == "script" and "mesh-data" in classes:
            self.reading = True
            self.meshes[self.figure] = ""

    def handle_endtag(self, tag):
        if tag == "script":
            self.reading = False

    def handle_data(self, data):
        if self.reading:
            self.meshes[self.figure] += data


class Mesh:
    """Elements as (lower corner, upper corner, level) and nodes as points with vectors, in exact coordinates."""

    def __init__(self, text):
        self.json = json.loads(text)
        self.lines = [[Fraction(line) for line in axis] for axis in self.json["lines"]]
        self.elements = [self._element(row) for row in self._rows("elements", 7)]
        self.nodes = [self._node(row) for row in self._rows("nodes", 6)]

    def _rows(self, table, width):
        data = base64.b64decode(self.json[table]["data"], validate=True)
        assert len(data) == 4 * width * self.json[table]["count"]
        return struct.iter_unpack(f"<{width}i", data)

    def _element(self, row):
        lower = tuple(self.lines[axis][row[2 * axis]] for axis in range(3))
        upper = tuple(self.lines[axis][row[2 * axis + 1]] for axis in range(3))
        return lower, upper, row[6]

    def _node(self, row):
        place = tuple(self.lines[axis][row[axis]] for axis in range(3))
        if row[3] < 0:
            return place, None
        vectors = [[self.lines[axis][line] for line in self.json["vectors"][axis][row[3 + axis]]] for axis in range(3)]
        return place, vectors

    def cut(self, axis, place):
        """Elements whose closed box meets the plane with area; those of them that the plane goes through."""
        touched = [e for e in self.elements if e[0][axis] <= place <= e[1][axis]]
        return touched, [e for e in touched if e[0][axis] < place < e[1][axis]]

    def seen_in(self, axis, place, from_above):
        """The elements that a slice shows: those on the side away from the reader; at the domain's own side, where
        there are none, those on the other one."""
        below = [e for e in self.elements if e[0][axis] < place <= e[1][axis]]
        above = [e for e in self.elements if e[0][axis] <= place < e[1][axis]]
        return (below or above) if from_above else (above or below)

    def support(self, node):
        return [(vector[0], vector[-1]) for vector in self.nodes[node][1]]


def meshes_of(path):
    with open(path, encoding="utf-8") as file:
        parser = _Figures()
        parser.feed(file.read())
    return {name: Mesh(text) for name, text in parser.meshes.items()}


def exact(number):
    """A fraction as the program writes it."""
    return str(number)


def tuple_text(numbers):
    return "(" + ", ".join(exact(number) for number in numbers) + ")"
