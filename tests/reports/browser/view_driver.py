"""One interactive view of an open page: what it shows, and a reader's ways to change that."""

import math
from fractions import Fraction


class View:
    def __init__(self, page, figure):
        self.page = page
        self.figure = figure
        self.canvas = f"#{figure} canvas"

    def __getattr__(self, name):
        """A data attribute: `slice_axis` is data-slice-axis."""
        camel = name.split("_")[0] + "".join(word.title() for word in name.split("_")[1:])
        return self.page.evaluate(f"document.querySelector('#{self.figure}').dataset.{camel}")

    def text(self, selector):
        return self.page.evaluate(f"document.querySelector('#{self.figure} {selector}').textContent")

    def texts(self, selector):
        return self.page.evaluate(
            f"[...document.querySelectorAll('#{self.figure} {selector}')].map(e => e.textContent)")

    def click_on(self, selector):
        self.page.click_on(f"#{self.figure} {selector}")

    def press_on(self, selector, *keys):
        self.page.evaluate(f"document.querySelector('#{self.figure} {selector}').focus()")
        for key in keys:
            self.page.press(key)
        self.page.settle()

    def choose_axis(self, axis):
        self.click_on(f"input[type=radio][value={axis}]")

    def show(self, **boxes):
        for name, on in boxes.items():
            if self.page.evaluate(f"document.querySelector('#{self.figure} input[name={name}]').checked") != on:
                self.click_on(f"input[name={name}]")

    def image(self):
        return self.page.evaluate(f"document.querySelector('{self.canvas}').toDataURL()")

    # ---- where things are on the canvas -----------------------------------------------------------------------------

    def numbers(self, attribute):
        return [float(word) for word in getattr(self, attribute).split()]

    def on_canvas(self, point):
        units, origin = self.numbers("units"), self.numbers("origin")
        return [origin[k] + sum(float(point[axis]) * units[2 * axis + k] for axis in range(3)) for k in range(2)]

    def click_at(self, point):
        """A click where a point of the index domain is drawn."""
        self.page.centre_of(self.canvas)
        left, top = self.page.evaluate(
            f"(r => [r.left, r.top])(document.querySelector('{self.canvas}').getBoundingClientRect())")
        x, y = self.on_canvas(point)
        self.page.click(left + x, top + y)

    def colours_at(self, places):
        """Red, green, blue of pixels, read from a copy: the picture's own canvas is not made for reading."""
        return self.page.evaluate(f"""(() => {{
            const canvas = document.querySelector('{self.canvas}');
            const ratio = canvas.width / canvas.clientWidth;
            const copy = document.createElement('canvas');
            Object.assign(copy, {{width: canvas.width, height: canvas.height}});
            const context = copy.getContext('2d', {{willReadFrequently: true}});
            context.drawImage(canvas, 0, 0);
            return {[list(place) for place in places]}.map(([x, y]) =>
                [...context.getImageData(Math.round(x * ratio), Math.round(y * ratio), 1, 1).data].slice(0, 3));
        }})()""")

    def legend_colours(self):
        """Of each level, as the page's own style gives it."""
        pairs = self.page.evaluate(f"""[...document.querySelectorAll('#{self.figure} li[data-level]')].map(li =>
            [li.dataset.level,
             getComputedStyle(li.querySelector('span')).backgroundColor.match(/\\d+/g).map(Number)])""")
        return {int(level): colour[:3] for level, colour in pairs}

    def towards(self):
        """The direction to the reader, from the angles."""
        yaw, pitch = math.radians(float(self.yaw)), math.radians(float(self.pitch))
        return (math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), math.sin(pitch))


def expected_faces(mesh, axis, place, towards):
    """How many element faces are seen of the half that the slice leaves: on the domain's sides towards the reader, and
    in the slice."""
    below = towards[axis] >= 0
    kept = [[Fraction(0), Fraction(length)] for length in mesh.json["domain"]]
    kept[axis][1 if below else 0] = place

    def seen(element, side):
        return all(max(kept[other][0], element[0][other]) < min(kept[other][1], element[1][other])
                   for other in range(3) if other != side)

    count = 0
    for side in range(3):
        if side == axis or abs(towards[side]) < 1e-9:
            continue
        end = mesh.json["domain"][side] if towards[side] > 0 else 0
        count += sum(1 for e in mesh.elements if e[1 if towards[side] > 0 else 0][side] == end and seen(e, side))
    if abs(towards[axis]) >= 1e-9:
        count += len(mesh.seen_in(axis, place, below))
    return count
