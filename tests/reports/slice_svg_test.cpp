#include "reports/slice_svg.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"
#include "properties/statement.hpp"
#include "reports/slices/svg.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

/// The slices of a case's last mesh that matter for what it violates.
std::vector<SlicePicture> pictures_of(const std::string& finding, const std::string& statement) {
  const std::string folder = std::string(ASTS_CASES) + "/../../reports/findings/";
  const Case test_case = read_case_file(folder + finding);
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  const Verdict verdict = try_on_case(find_statement(statement).value(), test_case).verdict;
  return slice_pictures(mesh, verdict.witness ? &*verdict.witness : nullptr);
}

Names names_of(const std::vector<SlicePicture>& pictures) {
  Names names;
  for (const SlicePicture& picture : pictures) names.push_back(picture.name);
  return names;
}

/// The parsed picture; throws when it is not well-formed.
class Parsed {
 public:
  explicit Parsed(const std::string& svg) {
    const pugi::xml_parse_result result = document_.load_string(svg.c_str());
    if (!result) throw std::runtime_error(result.description());
  }
  std::size_t count(const std::string& path) const { return document_.select_nodes(path.c_str()).size(); }
  std::size_t count_class(const std::string& name) const { return count("//*[@class='" + name + "']"); }
  Names texts(const std::string& path) const {
    Names result;
    for (const auto& found : document_.select_nodes(path.c_str())) result.push_back(found.node().text().get());
    return result;
  }
  std::string text(const std::string& path) const { return document_.select_node(path.c_str()).node().text().get(); }
  std::string attribute(const std::string& path, const char* name) const {
    return document_.select_node(path.c_str()).node().attribute(name).value();
  }

 private:
  pugi::xml_document document_;
};

// Through v = (2, 2, 2) and w = (2, 2, 3), orthogonal to each axis, each plane once.
TEST(SliceSvg, ChoosesThePlanesThroughBothNodes) {
  EXPECT_EQ(names_of(pictures_of("as-implies-dc.case", "dual-compatible")), (Names{"x-2", "y-2", "z-2", "z-3"}));
}

TEST(SliceSvg, ChoosesThePlanesThroughTheMeetingPoint) {
  EXPECT_EQ(names_of(pictures_of("dc-implies-as.case", "dc-implies-as")), (Names{"x-5_2", "y-5_2", "z-4"}));
}

TEST(SliceSvg, ChoosesTheMiddleWithoutAWitness) {
  EXPECT_EQ(names_of(pictures_of("as-implies-dc.case", "analysis-suitable")), (Names{"x-2", "y-2", "z-5_2"}));
}

// 16 traces of level 0, 1 of level 1, 2 of level 2: see SliceGeometry.HasTheElementsOnEitherSide.
TEST(SliceSvg, ShowsTheElementsWithLevels) {
  const Parsed svg(pictures_of("as-implies-dc.case", "dual-compatible").at(2).svg);
  EXPECT_EQ(svg.count_class("element"), 19U);
  EXPECT_EQ(svg.count("//*[@class='element' and @fill='#fafafa']"), 16U);
  EXPECT_EQ(svg.count("//*[@class='element' and @fill='#ececec']"), 1U);
  EXPECT_EQ(svg.count("//*[@class='element' and @fill='#dedede']"), 2U);
  EXPECT_EQ(svg.count_class("edge lower"), 3U + 1U) << "three elements and the legend";
  std::map<std::string, int> levels;
  for (const std::string& level : svg.texts("//*[@class='level']")) ++levels[level];
  EXPECT_EQ(levels, (std::map<std::string, int>{{"\u21950", 15}, {"\u21910", 1}, {"\u21931", 1}, {"\u21932", 2}}));
}

// 520 pixels for 4 units: an element of size 1/2 x 1/2 is 65 pixels wide, and 130 lower than the plane's middle line.
TEST(SliceSvg, IsToScale) {
  const Parsed svg(pictures_of("as-implies-dc.case", "dual-compatible").at(2).svg);
  const std::string finest = "//*[@fill='#dedede']";
  EXPECT_EQ(svg.attribute(finest, "width"), "65.00");
  EXPECT_EQ(svg.attribute(finest, "height"), "65.00");
  EXPECT_EQ(svg.attribute("//*[@fill='#ececec']", "height"), "130.00");
}

TEST(SliceSvg, ShowsTheNodes) {
  const auto pictures = pictures_of("as-implies-dc.case", "dual-compatible");
  const Parsed across(pictures.at(2).svg);
  EXPECT_EQ(across.texts("//*[@class='marked-node']/text"), (Names{"w (z = 3)", "v"}));
  EXPECT_EQ(across.count("//*[@class='marked-node']/*[@class='node hollow']"), 1U);
  EXPECT_EQ(across.count_class("support"), 2U);
  const Parsed along(pictures.at(0).svg);
  EXPECT_EQ(along.texts("//*[@class='marked-node']/text"), (Names{"w", "v"}));
  EXPECT_EQ(along.count("//*[@class='marked-node']/*[@class='node hollow']"), 0U);
}

// In the plane z = 2: v's vectors (1, 3/2, 2, 3, 4) along x and y, w's (0, 1, 2, 3, 4), which lack 3/2.
TEST(SliceSvg, ShowsTheIndexVectors) {
  const Parsed svg(pictures_of("as-implies-dc.case", "dual-compatible").at(2).svg);
  const Names v{"1", "3/2", "2", "3", "4", "v"};
  const Names w{"0", "1", "3/2", "2", "3", "4", "w"};
  for (const char* k : {"[1]", "[3]"}) EXPECT_EQ(svg.texts(std::string("(//g[@class='row'])") + k + "/text"), v);
  for (const char* k : {"[2]", "[4]"}) {
    const std::string row = std::string("(//g[@class='row'])") + k;
    EXPECT_EQ(svg.texts(row + "/text"), w);
    EXPECT_EQ(svg.count(row + "/*[@class='cross']"), 1U);
  }
}

// R_x = {5/2} x [2,3] x [4,6], R_y = [2,3] x {5/2} x [2,4] (see SliceGeometry.HasThePerturbedRegions), drawn with 65
// pixels a unit.
TEST(SliceSvg, ShowsThePerturbedRegions) {
  const auto pictures = pictures_of("dc-implies-as.case", "dc-implies-as");
  const Parsed svg(pictures.at(0).svg);
  EXPECT_EQ(svg.count("//*[@class='region x']/path"), 1U);
  EXPECT_EQ(svg.attribute("//g[@fill='url(#hatch-x)']/rect", "width"), "65.00");
  EXPECT_EQ(svg.attribute("//g[@fill='url(#hatch-x)']/rect", "height"), "130.00");
  EXPECT_EQ(svg.count("//*[@class='regions']/*[@class='segments y']/line"), 1U);
  EXPECT_EQ(svg.count("//*[@class='regions']/*[@class='segments z']"), 0U);
  EXPECT_EQ(svg.count_class("witness-point"), 1U);
  const Parsed across(pictures.at(2).svg);
  EXPECT_EQ(across.count("//*[@class='regions']/*[@class='segments x']/line"), 1U);
  EXPECT_EQ(across.count("//*[@class='regions']/*[@class='segments y']/line"), 1U);
}

TEST(SliceSvg, SaysTheSameInWords) {
  const Parsed svg(pictures_of("dc-implies-as.case", "dc-implies-as").at(0).svg);
  EXPECT_EQ(svg.text("/svg/title"), "Slice x = 5/2");
  const std::string words = svg.text("/svg/desc");
  for (const char* part :
       {"The plane x = 5/2 of the index domain, y to the right and z upwards, [0, 5] x [0, 8].",
        "The active region's projection is [2, 3] x [2, 6]; the plane meets the region.",
        "Perturbed region R_x in the plane: [2, 3] x [4, 6].",
        "Perturbed region R_y in the plane: [5/2, 5/2] x [2, 4].", "Perturbed region R_z in the plane: nothing.",
        "What is wrong: the perturbed regions R_x and R_y meet at t = (5/2, 5/2, 4).", "Point t = (5/2, 5/2, 4)."}) {
    EXPECT_NE(words.find(part), std::string::npos) << part << "\nin\n" << words;
  }
}

// The same bytes twice, and each picture is well-formed.
TEST(SliceSvg, IsDeterministic) {
  const auto once = pictures_of("dc-implies-as.case", "dc-implies-as");
  const auto again = pictures_of("dc-implies-as.case", "dc-implies-as");
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].svg, again[i].svg);
    EXPECT_EQ(Parsed(once[i].svg).count("/svg"), 1U);
  }
}

// Witnesses of every kind name a place inside the domain; names that XML must escape do no harm.
TEST(SliceSvg, DrawsAnyClaimsWitness) {
  const Case test_case = parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n", "case");
  Replay replay(test_case);
  MeshUnderTest mesh(replay.tree());
  const ExactBox box{{0, 0, 0}, {1, 1, 1}};
  const Witness witness = ClaimWitness{"kind",
                                       "a < b & \"c\"",
                                       {{"axis", std::string("y")},
                                        {"slice", Rational(7, 3)},
                                        {"first slice", std::string("z = 5/4")},
                                        {"<box>", box},
                                        {"far", ExactPoint{9, 9, 9}}}};
  const auto pictures = slice_pictures(mesh, &witness);
  EXPECT_EQ(names_of(pictures), (Names{"x-1_2", "y-1_2", "y-7_3", "z-1_2", "z-5_4"}));
  const Parsed svg(pictures.at(0).svg);
  EXPECT_NE(svg.text("/svg/desc").find("a < b & \"c\""), std::string::npos);
  EXPECT_EQ(svg.count_class("box"), 2U) << "the box and the legend";
}

TEST(Svg, RoundsExactly) {
  EXPECT_EQ(decimal(rounded_px(Rational(1, 3))), "0.33");
  EXPECT_EQ(decimal(rounded_px(Rational(2, 3))), "0.67");
  EXPECT_EQ(decimal(rounded_px(Rational(1, 200))), "0.01");
  EXPECT_EQ(decimal(rounded_px(Rational(-1, 200))), "0.00");
  EXPECT_EQ(decimal(rounded_px(Rational(-7, 3))), "-2.33");
  EXPECT_EQ(decimal(rounded_px(Rational(520))), "520.00");
}

TEST(Svg, StaggersLabels) {
  EXPECT_EQ(stagger({{0, 100}, {50, 100}, {100, 100}, {120, 100}}, 2), (std::vector<int>{0, 1, 0, -1}));
}

}  // namespace
}  // namespace asts::testing
