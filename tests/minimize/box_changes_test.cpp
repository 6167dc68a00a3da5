#include "lib/minimize/box_changes.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

Case boxes(const std::string& elements) {
  return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 1 1\n" + elements, "test");
}

const Case kThree = boxes("element 0 0 0  1 1 1\nelement 1 0 0  3/2 1 1\nelement 3/2 0 0  2 1 1\n");

std::string elements_of(const Case& test_case) {
  const std::string text = write_case(test_case);
  return text.substr(text.find("domain"));
}

TEST(BoxChanges, MoveCoordinates) {
  EXPECT_EQ(coordinates_of(kThree, 0), (std::vector<Rational>{0, 1, Rational(3) / 2, 2}));
  EXPECT_EQ(elements_of(with_coordinates(kThree, 0, {0, 1, 1, 2})),
            "domain 2 1 1\nelement 0 0 0  1 1 1\nelement 1 0 0  2 1 1\n");
  EXPECT_EQ(elements_of(boxes_without_layers(kThree, 0, 0, 1)),
            "domain 1 1 1\nelement 0 0 0  1/2 1 1\nelement 1/2 0 0  1 1 1\n");
  EXPECT_EQ(elements_of(boxes_without_layers(kThree, 0, 1, 1)), "domain 1 1 1\nelement 0 0 0  1 1 1\n");
}

TEST(BoxChanges, MergePairs) {
  EXPECT_EQ(elements_of(merged(kThree, {0, 1, std::nullopt})),
            "domain 2 1 1\nelement 0 0 0  1 1 1\nelement 1 0 0  2 1 1\n");
  EXPECT_EQ(elements_of(merged_at(kThree, 0, 1)), "domain 2 1 1\nelement 0 0 0  3/2 1 1\nelement 3/2 0 0  2 1 1\n");
  EXPECT_EQ(merged_at(kThree, 1, 0), kThree) << "nothing below the domain";
}

TEST(BoxChanges, MergeAllLayersOfAnExtrudedMesh) {
  const Case layers =
      boxes("element 0 0 0  1 1 1/2\nelement 1 0 0  2 1 1/2\nelement 0 0 1/2  1 1 1\nelement 1 0 1/2  2 1 1\n");
  EXPECT_EQ(merged(layers, {0, 0, std::nullopt}).elements.size(), 3U);
  EXPECT_EQ(elements_of(merged(layers, {0, 0, Axis{2}})),
            "domain 2 1 1\nelement 0 0 0  2 1 1/2\nelement 0 0 1/2  2 1 1\n");
}

TEST(BoxChanges, Turn) {
  EXPECT_EQ(elements_of(boxes_reflected(kThree, {true, false, false})),
            "domain 2 1 1\nelement 0 0 0  1/2 1 1\nelement 1/2 0 0  1 1 1\nelement 1 0 0  2 1 1\n");
  EXPECT_EQ(elements_of(boxes_permuted(kThree, {1, 0, 2})),
            "domain 1 2 1\nelement 0 0 0  1 1 1\nelement 0 1 0  1 3/2 1\nelement 0 3/2 0  1 2 1\n");
}

TEST(BoxChanges, RefineToTheClass) {
  const auto halves = refined_to_class(kThree, 9);
  ASSERT_TRUE(halves);
  EXPECT_EQ(subdivided_of(*halves), (std::vector<ElementPath>{{1, 0, 0}}));
  const Case along_y = boxes("element 0 0 0  2 1/2 1\nelement 0 1/2 0  2 1 1\n");
  EXPECT_EQ(subdivided_of(*refined_to_class(along_y, 9)).size(), 6U) << "each cube along x, then its halves along y";
  EXPECT_FALSE(refined_to_class(boxes("element 0 0 0  1/3 1 1\nelement 1/3 0 0  2 1 1\n"), 9)) << "no third is a half";
}

// Whatever a change gives tiles the domain: mesh_of throws when it does not.
TEST(BoxChanges, OfRandomMeshesTileTheDomain) {
  CaseLimits limits;
  limits.max_elements = 80;
  limits.max_cubes = 40;
  std::int64_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Draw draw(seed);
    const Case content = random_box_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    const Axis axis = draw.between(0, 2);
    const std::size_t box = draw.index(content.elements.size());
    std::vector<Case> changed{merged(content, {axis, box, std::nullopt}), merged(content, {axis, box, (axis + 1) % 3}),
                              boxes_permuted(boxes_reflected(content, {true, false, true}), {2, 0, 1})};
    const std::vector<Rational> coordinates = coordinates_of(content, axis);
    changed.push_back(merged_at(content, axis, coordinates[draw.index(coordinates.size())]));
    if (content.domain[at(axis)] > 1) {
      changed.push_back(boxes_without_layers(content, axis, draw.between(0, content.domain[at(axis)] - 1), 1));
    }
    for (const Case& one : changed) {
      EXPECT_NO_THROW(mesh_of(setting_of(one), one.elements)) << write_case(one);
      ++tried;
    }
  }
  EXPECT_GT(tried, 500);
}

}  // namespace
}  // namespace asts
