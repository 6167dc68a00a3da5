#include "reports/slices/slice_geometry.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"

namespace asts::testing {
namespace {

using Side = ElementTrace::Side;

const std::string kFindings = std::string(ASTS_CASES) + "/../../reports/findings/";

/// The last mesh of a case of steps.
class LastMesh {
 public:
  explicit LastMesh(Case test_case) : case_(std::move(test_case)), replay_(case_) {
    while (!replay_.done()) replay_.advance();
    mesh_.emplace(replay_.tree());
  }
  MeshUnderTest& mesh() { return *mesh_; }

 private:
  Case case_;
  Replay replay_;
  std::optional<MeshUnderTest> mesh_;
};

MeshUnderTest explicit_mesh(const std::string& text) {
  const Case test_case = parse_case(text, "case");
  return MeshUnderTest(mesh_of(setting_of(test_case), test_case.elements));
}

PlaneRectangle rectangle(Rational x1, Rational y1, Rational x2, Rational y2) { return {{x1, y1}, {x2, y2}}; }

std::map<std::pair<int, Side>, int> counts(const SliceGeometry& geometry) {
  std::map<std::pair<int, Side>, int> result;
  for (const ElementTrace& element : geometry.elements) ++result[{element.level.value(), element.side}];
  return result;
}

using Counts = std::map<std::pair<int, Side>, int>;

// [1,2]^3 is cut at x = 3/2, and its upper half at y = 3/2; the domain is 4 x 4 x 5. Each plane has faces of all
// elements beside it; the refined cube is on the lower side, where its four or five neighbours in the plane are alike.
TEST(SliceGeometry, HasTheElementsOnEitherSide) {
  LastMesh last(read_case_file(kFindings + "as-implies-dc.case"));
  EXPECT_EQ(counts(cut(last.mesh(), {2, 2})),
            (Counts{{{0, Side::both}, 15}, {{0, Side::upper}, 1}, {{1, Side::lower}, 1}, {{2, Side::lower}, 2}}));
  EXPECT_EQ(counts(cut(last.mesh(), {0, 2})),
            (Counts{{{0, Side::both}, 19}, {{0, Side::upper}, 1}, {{2, Side::lower}, 2}}));
  EXPECT_EQ(counts(cut(last.mesh(), {1, 2})),
            (Counts{{{0, Side::both}, 19}, {{0, Side::upper}, 1}, {{1, Side::lower}, 1}, {{2, Side::lower}, 1}}));
  EXPECT_EQ(counts(cut(last.mesh(), {2, 3})), (Counts{{{0, Side::both}, 16}}));
}

// The plane x = 3/2 cuts through 19 cubes; of the refined one it has a face: level 1 below, two of level 2 above.
TEST(SliceGeometry, TellsFacesFromElementsCutThrough) {
  LastMesh last(read_case_file(kFindings + "as-implies-dc.case"));
  const SliceGeometry geometry = cut(last.mesh(), {0, Rational(3, 2)});
  EXPECT_EQ(counts(geometry), (Counts{{{0, Side::through}, 19}, {{1, Side::lower}, 1}, {{2, Side::upper}, 2}}));
  EXPECT_EQ(geometry.elements[19].trace, rectangle(1, 1, 2, 2));
  EXPECT_EQ(geometry.elements[20].trace, rectangle(1, 1, Rational(3, 2), 2));
  EXPECT_EQ(geometry.elements[21].trace, rectangle(Rational(3, 2), 1, 2, 2));
  EXPECT_FALSE(geometry.in_active_region);
}

// The active region is {2} x {2} x [2,3].
TEST(SliceGeometry, HasTheActiveRegionAndItsNodes) {
  LastMesh last(read_case_file(kFindings + "as-implies-dc.case"));
  const SliceGeometry across = cut(last.mesh(), {2, 2});
  EXPECT_EQ(across.domain, rectangle(0, 0, 4, 4));
  EXPECT_EQ(across.active_region, rectangle(2, 2, 2, 2));
  EXPECT_TRUE(across.in_active_region);
  EXPECT_EQ(across.active_nodes, (std::vector<PlanePoint>{{2, 2}}));
  const SliceGeometry along = cut(last.mesh(), {0, 2});
  EXPECT_EQ(along.domain, rectangle(0, 0, 4, 5));
  EXPECT_EQ(along.active_region, rectangle(2, 2, 2, 3));
  EXPECT_EQ(along.active_nodes, (std::vector<PlanePoint>{{2, 2}, {2, 3}}));
  for (const auto& region : along.regions.value()) EXPECT_TRUE(region.empty());
}

// The active region is [2,3] x [2,3] x [2,6]. The faces at x = 5/2 make N_x(5/2) the nodes up to z = 5, whose supports
// end at z = 7; those of the nodes at z = 6 begin at z = 4. The face at y = 5/2 makes N_y(5/2) the nodes (2, y, 2) and
// (5/2, y, 2), whose supports end at z = 4. So R_x = {5/2} x [2,3] x [4,6], R_y = [2,3] x {5/2} x [2,4], R_z is empty.
TEST(SliceGeometry, HasThePerturbedRegions) {
  LastMesh last(read_case_file(kFindings + "dc-implies-as.case"));
  const Rational half(5, 2);
  using Regions = PerAxis<std::vector<PlaneRectangle>>;
  EXPECT_EQ(cut(last.mesh(), {0, half}).regions,
            (Regions{{{rectangle(2, 4, 3, 6)}, {rectangle(half, 2, half, 4)}, {}}}));
  EXPECT_EQ(cut(last.mesh(), {1, half}).regions,
            (Regions{{{rectangle(half, 4, half, 6)}, {rectangle(2, 2, 3, 4)}, {}}}));
  EXPECT_EQ(cut(last.mesh(), {2, 4}).regions,
            (Regions{{{rectangle(half, 2, half, 3)}, {rectangle(2, half, 3, half)}, {}}}));
  EXPECT_EQ(cut(last.mesh(), {2, 5}).regions, (Regions{{{rectangle(half, 2, half, 3)}, {}, {}}}));
  EXPECT_EQ(cut(last.mesh(), {0, 2}).regions, (Regions{{{}, {rectangle(half, 2, half, 4)}, {}}}));
}

// At the ends of the domain there is one side only.
TEST(SliceGeometry, HasTheDomainsFaces) {
  LastMesh last(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 2 3\nsubdivide 0 0 0\n", "case"));
  EXPECT_EQ(counts(cut(last.mesh(), {0, 0})), (Counts{{{0, Side::upper}, 5}, {{1, Side::upper}, 1}}));
  EXPECT_EQ(counts(cut(last.mesh(), {0, 1})), (Counts{{{0, Side::lower}, 5}, {{1, Side::lower}, 1}}));
  EXPECT_THROW(cut(last.mesh(), {0, 2}), InputError);
  EXPECT_THROW(cut(last.mesh(), {0, -1}), InputError);
}

// Eight boxes of side 2: the active node (2, 2, 2) has three entries on each line, and index vectors need five.
TEST(SliceGeometry, SaysNothingOfRegionsWithoutIndexVectors) {
  std::string text = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n";
  for (const char* x : {"0 ", "2 "}) {
    for (const char* y : {"0 ", "2 "}) {
      for (const char* z : {"0 ", "2 "}) {
        const auto upper = [](const char* lower) { return lower[0] == '0' ? "2 " : "4 "; };
        text += std::string("element ") + x + y + z + upper(x) + upper(y) + upper(z) + "\n";
      }
    }
  }
  MeshUnderTest mesh = explicit_mesh(text);
  const SliceGeometry geometry = cut(mesh, {2, 1});
  EXPECT_FALSE(geometry.regions);
  EXPECT_EQ(geometry.elements.size(), 4U);
  EXPECT_EQ(geometry.active_region, rectangle(2, 2, 2, 2));
}

}  // namespace
}  // namespace asts::testing
