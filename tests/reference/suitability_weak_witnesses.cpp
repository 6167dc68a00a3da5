#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/suitability_claims.hpp"
#include "tests/reference/suitability_kinds.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

struct Pair {
  ActiveNode<Rational> v, w;
};

Pair read_pair(const Space<Rational>& space, const json& values) {
  Pair pair{checked_active_node(space, values["v"], "v"), checked_active_node(space, values["w"], "w")};
  if (pair.v.node == pair.w.node) throw Rejected("v and w are the same node");
  return pair;
}

std::string described_pair(const Pair& pair, const std::vector<std::size_t>& axes) {
  std::string result = "v = " + text(pair.v.node) + " and w = " + text(pair.w.node) + " are active nodes.";
  for (const std::size_t a : axes)
    result += " " + described_vector(pair.v, a) + " and " + described_vector(pair.w, a) +
              (overlap(pair.v.vectors[a], pair.w.vectors[a]) ? " overlap." : " do not overlap.");
  return result;
}

}  // namespace

std::string check_weak_overlap(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"v", "w"});
  const std::string exist = splines_exist(subject.setting(), subject.mesh());
  const Pair pair = read_pair(make_space<Rational>(subject.setting(), subject.mesh(), 1), values);
  if (!partially_overlap(pair.v, pair.w)) throw Rejected("v and w do not overlap along two axes");
  if (weakly_overlap(pair.v, pair.w, {0, 1, 2}))
    throw Rejected("nothing is violated: v and w have different, overlapping vectors along some axis");
  return described_pair(pair, {0, 1, 2}) + exist +
         " They overlap along two axes, and along no axis they have different, overlapping vectors.";
}

std::string check_weak_overlap_in_plane(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"extruded_along", "v", "w"});
  const std::string exist = splines_exist(subject.setting(), subject.mesh());
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const std::size_t axis = read_axis(values["extruded_along"]);
  if (!extruded(space, axis)) throw Rejected(std::string("the mesh is not extruded along ") + axis_name(axis));
  const Pair pair = read_pair(space, values);
  if (pair.v.node[axis] != pair.w.node[axis]) throw Rejected("v and w are not in one plane");
  const std::vector<std::size_t> planar{axis == 0 ? 1U : 0U, axis == 2 ? 1U : 2U};
  const bool partially = overlaps(pair.v, pair.w, planar) >= 1, weakly = weakly_overlap(pair.v, pair.w, planar);
  if (partially == weakly)
    throw Rejected(std::string("nothing is violated: both definitions say that v and w ") +
                   (partially ? "partially overlap" : "do not partially overlap"));
  return described_pair(pair, planar) + exist + (partially ? " They overlap" : " They do not overlap") +
         " along one of the plane's axes, and have " + (weakly ? "" : "no ") +
         "different, overlapping vectors along one of them.";
}

}  // namespace asts::reference
