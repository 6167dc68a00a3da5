#include "properties/claims/index_entries.hpp"

#include <algorithm>

#include "lib/spline/active_nodes.hpp"

namespace asts {

namespace {

int frame_width(const Mesh& mesh, Axis axis) { return (mesh.setting.degree[at(axis)] + 1) / 2; }

/// The integers that the note names, ascending.
std::vector<Rational> frame_entries(const Mesh& mesh, Axis axis) {
  const int length = mesh.setting.domain[at(axis)];
  const int width = frame_width(mesh, axis);
  std::vector<Rational> entries;
  for (int i = 0; i < width; ++i) {
    entries.emplace_back(i);
    entries.emplace_back(length - i);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::vector<Rational> coordinates_of(const Mesh& mesh, Axis axis, const std::vector<std::int32_t>& ranks) {
  std::vector<Rational> result;
  for (const std::int32_t rank : ranks) result.push_back(mesh.coordinate(axis, rank));
  return result;
}

bool is_integer(const Rational& number) { return boost::multiprecision::denominator(number) == 1; }

/// The middle of a cell across an axis.
ExactPoint middle_of(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& cell) {
  ExactPoint point;
  for (Axis other = 0; other < kDimension; ++other) {
    if (other == axis) continue;
    const std::int32_t rank = cell[at(other)] / 2;
    point[at(other)] = (mesh.coordinate(other, rank) + mesh.coordinate(other, rank + 1)) / 2;
  }
  return point;
}

Verdict missing_entry(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& cell, const Rational& entry,
                      std::vector<Rational> set) {
  return Verdict::violated(ClaimWitness{"entry-missing",
                                        "the global index set along the axis through the point lacks the entry",
                                        {{"axis", std::string(axis_name(axis))},
                                         {"point", middle_of(mesh, axis, cell)},
                                         {"length", std::int64_t{mesh.setting.domain[at(axis)]}},
                                         {"degree", std::int64_t{mesh.setting.degree[at(axis)]}},
                                         {"entry", entry},
                                         {"index_set", std::move(set)}}});
}

/// Calls visit(cell) with a point in each cell between the mesh's lines across an axis, until it returns false.
template <class Visit>
void for_each_cell_across(const Mesh& mesh, Axis axis, const Visit& visit) {
  const Axis first = axis == 0 ? 1 : 0;
  const Axis second = axis == 2 ? 1 : 2;
  const auto cells = [&](Axis other) { return static_cast<HalfRank>(mesh.coordinates[at(other)].size()) - 1; };
  for (HalfRank i = 0; i < cells(first); ++i) {
    for (HalfRank j = 0; j < cells(second); ++j) {
      PerAxis<HalfRank> cell{};
      cell[at(first)] = 2 * i + 1;
      cell[at(second)] = 2 * j + 1;
      if (!visit(cell)) return;
    }
  }
}

/// The first of the entries that the set lacks. REQUIRES: both ascend.
std::optional<Rational> first_missing(const std::vector<Rational>& entries, const std::vector<Rational>& set) {
  for (const Rational& entry : entries) {
    if (!std::binary_search(set.begin(), set.end(), entry)) return entry;
  }
  return std::nullopt;
}

}  // namespace

Trial judge_frame_entries(const Mesh& mesh, const PerAxis<bool>& axes) {
  Trial trial;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (!axes[at(axis)]) continue;
    const std::vector<Rational> entries = frame_entries(mesh, axis);
    for_each_cell_across(mesh, axis, [&](const PerAxis<HalfRank>& cell) {
      const std::vector<Rational> set = coordinates_of(mesh, axis, global_index_set(mesh, axis, cell));
      trial.met += !std::all_of(set.begin(), set.end(), is_integer);
      const auto missing = first_missing(entries, set);
      if (missing) trial.verdict = missing_entry(mesh, axis, cell, *missing, set);
      return !missing;
    });
    if (trial.verdict.outcome == Outcome::violated) return trial;
  }
  return trial;
}

Trial frame_in_index_sets(MeshUnderTest& mesh) {
  if (!mesh.admissible()) return {Verdict::not_applicable("the mesh is not admissible")};
  return judge_frame_entries(mesh.mesh(), {true, true, true});
}

// A refinement of the initial mesh has all integers of [0,X~] in every index set: the face between two unit cubes, or
// on the domain's border, stays a union of faces when the cubes beside it are divided. So the note holds for an axis
// if the integers that it names are in [0,X~], which is ceil(p/2)-1 <= X~. (For larger X~ they are; for smaller ones
// X(y,z), a subset of [0,X~], cannot have them.) Subdivisions need not be admissible for that.
Trial frame_in_index_sets_repaired(MeshUnderTest& mesh) {
  if (mesh.outside_class()) return {Verdict::not_applicable("the mesh is not made by subdivisions")};
  PerAxis<bool> long_enough;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    long_enough[at(axis)] = mesh.mesh().setting.domain[at(axis)] >= frame_width(mesh.mesh(), axis) - 1;
  }
  if (long_enough == PerAxis<bool>{false, false, false}) {
    return {Verdict::not_applicable("every axis is shorter than the frame's integers")};
  }
  return judge_frame_entries(mesh.mesh(), long_enough);
}

namespace {

/// Where windows of `length` consecutive entries with the given middle begin. REQUIRES: the length is odd.
std::vector<std::size_t> windows_around(const std::vector<std::int32_t>& set, std::int32_t middle, std::size_t length) {
  std::vector<std::size_t> begins;
  for (std::size_t begin = 0; begin + length <= set.size(); ++begin) {
    if (set[begin + length / 2] == middle) begins.push_back(begin);
  }
  return begins;
}

bool consecutive_integers(const Mesh& mesh, Axis axis, const std::vector<std::int32_t>& set, std::size_t begin,
                          std::size_t length) {
  for (std::size_t i = begin; i < begin + length; ++i) {
    if (!is_integer(mesh.coordinate(axis, set[i]))) return false;
  }
  return true;
}

Verdict no_unique_vector(const Mesh& mesh, Axis axis, const PerAxis<std::int32_t>& node,
                         const std::vector<std::int32_t>& set, std::size_t windows) {
  ExactPoint point;
  for (Axis other = 0; other < kDimension; ++other) point[at(other)] = mesh.coordinate(other, node[at(other)]);
  return Verdict::violated(ClaimWitness{"no-unique-index-vector",
                                        "not exactly one choice of p+2 consecutive entries along the axis has the "
                                        "active node in the middle",
                                        {{"axis", std::string(axis_name(axis))},
                                         {"node", point},
                                         {"length", std::int64_t{mesh.setting.degree[at(axis)]} + 2},
                                         {"choices", static_cast<std::int64_t>(windows)},
                                         {"index_set", coordinates_of(mesh, axis, set)}}});
}

}  // namespace

Trial judge_index_vectors(const Mesh& mesh) {
  Trial trial;
  for (const PerAxis<std::int32_t>& node : active_nodes(mesh, active_region(mesh)).positions) {
    PerAxis<HalfRank> position;
    for (std::size_t axis = 0; axis < kDimension; ++axis) position[axis] = 2 * node[axis];
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const auto length = static_cast<std::size_t>(mesh.setting.degree[at(axis)]) + 2;
      const std::vector<std::int32_t> set = global_index_set(mesh, axis, position);
      const std::vector<std::size_t> begins = windows_around(set, node[at(axis)], length);
      if (begins.size() != 1) {
        trial.verdict = no_unique_vector(mesh, axis, node, set, begins.size());
        return trial;
      }
      trial.met += !consecutive_integers(mesh, axis, set, begins.front(), length);
    }
  }
  return trial;
}

Trial index_vectors_exist(MeshUnderTest& mesh) {
  if (mesh.outside_class()) return {Verdict::not_applicable("the mesh is not made by subdivisions")};
  return judge_index_vectors(mesh.mesh());
}

}  // namespace asts
