#include "lib/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/tree.hpp"

namespace asts {
namespace {

/// The mesh of a case text's elements; degree 3, grading 2 unless the text says otherwise.
Mesh mesh_of_elements(const std::string& elements, const std::string& domain = "2 1 1",
                      const std::string& grading = "2") {
  const Case content =
      parse_case("asts-case 1\ndegree 3 3 3\ngrading " + grading + "\ndomain " + domain + "\n" + elements, "f");
  return mesh_of(setting_of(content), content.elements);
}

/// What mesh_of says against the elements, which begin in line 5.
std::string refusal(const std::string& elements, const std::string& domain = "2 1 1") {
  try {
    mesh_of_elements(elements, domain);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BoxMesh, KeepsTheOrderOfTheLines) {
  const Mesh mesh = mesh_of_elements("element 1 0 0 2 1 1\nelement 0 0 0 1/3 1 1\nelement 1/3 0 0 1 1 1\n");
  ASSERT_EQ(mesh.elements.size(), 3U);
  EXPECT_EQ(mesh.coordinates[0], (std::vector<Rational>{0, Rational(1) / 3, 1, 2}));
  EXPECT_EQ(mesh.coordinates[1], (std::vector<Rational>{0, 1}));
  EXPECT_EQ(mesh.elements[0], (Box{{2, 0, 0}, {3, 1, 1}}));
  EXPECT_EQ(mesh.elements[1], (Box{{0, 0, 0}, {1, 1, 1}}));
}

// Definition 2.2: the level is -log_m of the volume: 0 for volume 1, 2 for 1/4, -1 for 2, none for 1/3.
TEST(BoxMesh, LevelsAreThoseOfTheVolume) {
  const Mesh mesh = mesh_of_elements(
      "element 0 0 0 2 1 1\nelement 0 1 0 1 2 1\nelement 1 1 0 5/4 2 1\nelement 5/4 1 0 19/12 2 1\n"
      "element 19/12 1 0 2 2 1\n",
      "2 2 1");
  EXPECT_EQ(mesh.levels, (std::vector<std::int32_t>{-1, 0, 2, Mesh::kNoLevel, Mesh::kNoLevel}));
}

TEST(BoxMesh, AnOverlapNamesBothLines) {
  EXPECT_EQ(refusal("element 0 0 0 1 1 1\nelement 1/2 0 0 2 1 1\n"), "6: this element overlaps the one of line 5");
  EXPECT_EQ(refusal("element 0 0 0 2 1 1\nelement 0 0 0 2 1 1\n"), "6: this element overlaps the one of line 5");
  // the same volume as the domain's: a gap and an overlap at once; either may be named
  const std::string both = refusal("element 0 0 0 1 1 1\nelement 0 0 0 1 1 1\n");
  EXPECT_TRUE(both.starts_with("6: ")) << both;
}

TEST(BoxMesh, AGapNamesTheMissingBox) {
  EXPECT_EQ(refusal("element 0 0 0 1 1 1\n"), "5: the elements leave a gap: none covers [1, 2] x [0, 1] x [0, 1]");
  EXPECT_TRUE(refusal("element 0 0 0 1 1 1\nelement 1 0 0 2 1/2 1\n").starts_with("6: the elements leave a gap"));
}

// Five boxes around a middle one, which no plane separates; without the middle there is a gap, with a larger one an
// overlap.
TEST(BoxMesh, TakesPinwheels) {
  const std::string arms = "element 0 0 0 2 1 1\nelement 2 0 0 3 2 1\nelement 1 2 0 3 3 1\nelement 0 1 0 1 3 1\n";
  const Mesh mesh = mesh_of_elements(arms + "element 1 1 0 2 2 1\n", "3 3 1");
  EXPECT_EQ(mesh.elements.size(), 5U);
  EXPECT_EQ(refusal(arms, "3 3 1"), "8: the elements leave a gap: none covers [1, 2] x [1, 2] x [0, 1]");
  EXPECT_TRUE(refusal(arms + "element 1 1 0 2 5/2 1\n", "3 3 1").find("overlaps") != std::string::npos);
}

// [0,1/2] x [0,1]^2 is in the class for m = 2; [0,1] x [0,1/2] x [0,1] is cut along the wrong axis for level 1, and
// [1/4,3/4] x [0,1]^2 has the size of a level-1 element in no level-1 element's place.
TEST(Recognise, TellsTheBoxesOfTheClass) {
  const Mesh mesh = mesh_of_elements(
      "element 0 0 0 1/2 1 1\nelement 1/2 0 0 1 1 1\nelement 1 0 0 2 1/2 1\nelement 1 1/2 0 2 1 1\n"
      "element 2 0 0 9/4 1 1\nelement 9/4 0 0 11/4 1 1\nelement 11/4 0 0 3 1 1\nelement 3 0 0 7/2 1/2 1\n"
      "element 3 1/2 0 7/2 1 1\nelement 7/2 0 0 4 1 1\n",
      "4 1 1");
  const RecognisedTree recognised = recognise(mesh);
  EXPECT_FALSE(recognised.complete());
  const std::vector<bool> expected{true, true, false, false, false, false, false, true, true, true};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::int32_t id = recognised.node_of_element[i];
    EXPECT_EQ(id != RefinementTree::kNone, expected[i]) << i;
    if (id == RefinementTree::kNone) continue;
    EXPECT_EQ(literal::box(recognised.tree, id), literal::box(mesh, mesh.elements[i]));
  }
}

/// Every cell between neighbouring lines, by trying all elements.
void expect_locator(const Mesh& mesh) {
  PerAxis<std::int32_t> cell{};
  const auto last = [&](std::size_t axis) { return static_cast<std::int32_t>(mesh.coordinates[axis].size()) - 1; };
  for (cell[0] = 0; cell[0] < last(0); ++cell[0]) {
    for (cell[1] = 0; cell[1] < last(1); ++cell[1]) {
      for (cell[2] = 0; cell[2] < last(2); ++cell[2]) {
        const auto element = static_cast<std::size_t>(mesh.locator.element_at(cell));
        ASSERT_LT(element, mesh.elements.size());
        for (std::size_t axis = 0; axis < kDimension; ++axis) {
          ASSERT_LE(mesh.elements[element].lower[axis], cell[axis]);
          ASSERT_GT(mesh.elements[element].upper[axis], cell[axis]);
        }
      }
    }
  }
}

// Elements tile the domain, so that the covering element is unique.
TEST(Locator, FindsTheElementThatCoversACell) {
  Draw draw(8);
  for (int round = 0; round < 60; ++round) {
    const Case boxes = random_box_case(draw, {}).content;
    expect_locator(mesh_of(setting_of(boxes), boxes.elements));
    const Case steps = random_bare_case(draw, {}).content;
    Replay replay(steps);
    while (!replay.done()) replay.advance();
    expect_locator(mesh_of(replay.tree()));
  }
}

// The tree's leaves, and what is made of them when they are written as boxes: the same set, the same levels.
TEST(TreeMesh, IsTheSetOfLeavesAndSurvivesBeingWrittenAsBoxes) {
  Draw draw(9);
  for (int round = 0; round < 60; ++round) {
    const Case content = random_bare_case(draw, {}).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    while (!replay.done()) replay.advance();
    const Mesh mesh = mesh_of(replay.tree());
    const reference::Setting setting = literal::setting(mesh.setting);
    const reference::Mesh boxes = literal::mesh(mesh);
    EXPECT_EQ(literal::sorted(boxes), literal::sorted(literal::last_mesh(content)));
    std::vector<ElementLine> lines;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_EQ(mesh.levels[i], reference::level(setting, boxes[i]));
      ElementLine line;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        line.lower[axis] = CompactRational(boxes[i].lower[axis]);
        line.upper[axis] = CompactRational(boxes[i].upper[axis]);
      }
      lines.push_back(line);
    }
    const Mesh again = mesh_of(mesh.setting, lines);
    EXPECT_EQ(again.levels, mesh.levels);
    EXPECT_EQ(literal::mesh(again), boxes);
    const RecognisedTree recognised = recognise(again);
    EXPECT_TRUE(recognised.complete());
    EXPECT_EQ(recognised.tree.element_count(), replay.tree().element_count());
  }
}

// Which boxes are in the class, against the literal code, on meshes that subdivisions do not make.
TEST(Recognise, AgreesWithTheLiteralClassOnRandomBoxes) {
  Draw draw(10);
  int outside = 0;
  for (int round = 0; round < 100; ++round) {
    const Case content = random_box_case(draw, {}).content;
    const Mesh mesh = mesh_of(setting_of(content), content.elements);
    const RecognisedTree recognised = recognise(mesh);
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
      const reference::Box box = literal::box(mesh, mesh.elements[i]);
      const bool in_class = reference::in_class(literal::setting(mesh.setting), box);
      EXPECT_EQ(recognised.node_of_element[i] != RefinementTree::kNone, in_class) << write_case(content);
      outside += !in_class;
    }
  }
  EXPECT_GT(outside, 300);
}

}  // namespace
}  // namespace asts
