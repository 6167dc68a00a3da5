"""What a view shows, compared with the page's JSON as Python reads it; `test` is a unittest.TestCase."""

import math
from fractions import Fraction

from page_data import AXES, exact, tuple_text
from view_driver import expected_faces


def check_slice(test, view, mesh, axis, place):
    touched, through = mesh.cut(axis, place)
    in_plane = [node for node in mesh.nodes if node[0][axis] == place]
    test.assertEqual((view.slice_axis, view.slice_position), (AXES[axis], exact(place)))
    test.assertEqual((view.slice_elements, view.slice_through, view.slice_nodes),
                     (str(len(touched)), str(len(through)), str(len(in_plane))))
    test.assertEqual(view.drawn, str(expected_faces(mesh, axis, place, view.towards())))
    text = view.text(".mesh-view-slice")
    ends = sum(1 for element in touched if element[1][axis] == place)
    begins = sum(1 for element in touched if element[0][axis] == place)
    at_line = f", that end there: {ends}, that begin there: {begins}" if place in mesh.lines[axis] else ""
    test.assertEqual(text, f"{AXES[axis]} = {exact(place)}. Elements that it goes through: {len(through)}{at_line}. "
                           f"Active nodes in it: {len(in_plane)}.")


def check_camera(test, view, mesh):
    """The picture of the axes is that of a camera at these angles: lengths and angles on the canvas are right."""
    yaw, pitch = math.radians(float(view.yaw)), math.radians(float(view.pitch))
    right = (-math.sin(yaw), math.cos(yaw), 0)
    up = (-math.sin(pitch) * math.cos(yaw), -math.sin(pitch) * math.sin(yaw), math.cos(pitch))
    units = view.numbers("units")
    scale = math.sqrt(sum(unit * unit for unit in units) / 2)
    for axis in range(3):
        test.assertAlmostEqual(units[2 * axis], scale * right[axis], places=6)
        test.assertAlmostEqual(units[2 * axis + 1], -scale * up[axis], places=6)
    axis = AXES.index(view.slice_axis)
    test.assertEqual(view.drawn, str(expected_faces(mesh, axis, Fraction(view.slice_position), view.towards())))
    return scale


def check_picked(test, view, mesh, nodes):
    test.assertEqual(view.picked_node, " ".join(map(str, nodes)))
    shown = view.texts(".mesh-view-node p")
    test.assertEqual(len(shown), len(nodes))
    for index, node in enumerate(nodes):
        place, vectors = mesh.nodes[node]
        test.assertIn(f"= {tuple_text(place)}, active node {node + 1} of {len(mesh.nodes)}", shown[index])
        box = f'[data-node="{node}"]'
        test.assertEqual(view.texts(f"{box} [data-vector]"), [
            f"index vector along {AXES[axis]}: {tuple_text(vectors[axis])}" for axis in range(3)])
        support = mesh.support(node)
        words = " × ".join(f"[{exact(low)}, {exact(high)}]" for low, high in support)
        inside = sum(1 for low, high, _ in mesh.elements
                     if all(low[a] < support[a][1] and support[a][0] < high[a] for a in range(3)))
        test.assertEqual(view.text(f"{box} [data-support]"),
                         f"support: {words}, which {inside} elements share volume with")
