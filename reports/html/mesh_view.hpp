#pragma once

#include <string>
#include <string_view>

#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"

namespace asts {

/// What the interactive view of a report needs to show a mesh: one JSON object, to stand in
/// `<script type="application/json" class="mesh-data">` inside a `<figure class="mesh-view">`; no `<` occurs in it.
/// Every coordinate is exact: a "line" is the place of a coordinate in `lines`, where it is a string such as "5/2"; a
/// "place" is a line, or such a string where no line of the mesh runs.
///
/// | key | content |
/// |---|---|
/// | `degree`, `domain` | a number an axis |
/// | `grading` | m |
/// | `lines` | for each axis the coordinates of the lines in use, ascending |
/// | `elements` | `count`; `data`: 7 numbers an element, in the mesh's order: lines x0, x1, y0, y1, z0, z1, the level |
/// | `nodes` | `count`; `data`: 6 numbers an active node: lines x, y, z, its index vectors by number, -1 when unknown |
/// | `vectors` | for each axis the index vectors (Definition 4.4), lists of p+2 lines; none if one does not exist |
/// | `active` | the active region (Definition 4.1): for each axis two places; null when empty |
/// | `regions` | for each axis the closures of the perturbed region's parts (Definition 5.1), 6 places each: x0, x1,
/// y0, ..; null where they are not known: some vector does not exist, or beyond kMostElementsWithRegions or a budget |
/// | `says` | what the witness says, in a sentence; empty without one |
/// | `picked` | the nodes that the witness names, by number |
/// | `elements_picked` | the elements that it names, by number |
/// | `marks` | what it names, with the names that the text uses: `nodes` (`name`, `node`: number), `points` (`name`,
/// `at`: three strings), `boxes` (`name`, `lower`, `upper`); nodes of another mesh are left out |
///
/// A table's `data` is base64 of 32-bit integers, least significant byte first; a level that is no integer is -2^31.
/// Without a witness: nullptr. Cost: linear in the mesh, and that of its index vectors and perturbed regions.
std::string mesh_view_json(MeshUnderTest& mesh, const Witness* witness);

/// Beyond it `regions` are null: they are too much to draw, and take longer than the rest of a report.
inline constexpr std::size_t kMostElementsWithRegions = 20'000;

/// What makes every `figure.mesh-view` of a page interactive: the text of one `script`, to stand behind all figures,
/// and of one `style`. They need no network and leave what else is on the page alone. Without the script the
/// figure's `svg` stays.
std::string_view mesh_view_script();
std::string_view mesh_view_style();

}  // namespace asts
