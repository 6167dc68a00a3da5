#include "reports/html/mesh_view.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/statement.hpp"
#include "reports/base64.hpp"

namespace asts::testing {
namespace {

using Json = nlohmann::json;
using Numbers = std::vector<std::int32_t>;
using Texts = std::vector<std::string>;

const std::string kCases = ASTS_CASES;

/// The last mesh of a case with the witness of a statement, when one is named.
class Subject {
 public:
  explicit Subject(Case test_case, const std::string& statement = {}) : case_(std::move(test_case)) {
    if (case_.explicit_mesh) {
      mesh_.emplace(mesh_of(setting_of(case_), case_.elements));
    } else {
      replay_.emplace(case_);
      while (!replay_->done()) replay_->advance();
      mesh_.emplace(replay_->tree());
    }
    if (!statement.empty()) verdict_ = try_on_case(find_statement(statement).value(), case_).verdict;
  }

  MeshUnderTest& mesh() { return *mesh_; }
  std::string text() { return mesh_view_json(*mesh_, verdict_.witness ? &*verdict_.witness : nullptr); }
  Json json() { return Json::parse(text()); }

 private:
  Case case_;
  std::optional<Replay> replay_;
  std::optional<MeshUnderTest> mesh_;
  Verdict verdict_;
};

Subject finding(const std::string& name, const std::string& statement) {
  return Subject(read_case_file(kCases + "/../../reports/findings/" + name), statement);
}

Subject of_text(const std::string& text) { return Subject(parse_case(text, "case")); }

/// RFC 4648, section 4, read digit by digit; 32-bit integers, the least significant byte first.
Numbers decoded(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint32_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) >= 8) bytes.push_back(bits >> (count -= 8) & 255U);
  }
  Numbers result;
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    result.push_back(static_cast<std::int32_t>(bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 | bytes[i + 3] << 24));
  }
  return result;
}

Texts vector_of_node(const Json& json, std::size_t node, std::size_t axis) {
  const Numbers nodes = decoded(json["nodes"]["data"]);
  Texts result;
  for (const std::size_t line : json["vectors"][axis][static_cast<std::size_t>(nodes[6 * node + 3 + axis])]) {
    result.push_back(json["lines"][axis][line]);
  }
  return result;
}

/// The coordinates of a list of places, given axis by axis, `each` numbers an axis.
Texts place_texts(const Json& json, const Json& places, std::size_t each) {
  Texts result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Json& lines = json["lines"][i / each];
    result.push_back(places[i].is_string() ? places[i] : lines[places[i].get<std::size_t>()]);
  }
  return result;
}

TEST(MeshView, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64_of({}), "");
  EXPECT_EQ(base64_of({1}), "AQAAAA==");
  EXPECT_EQ(base64_of({-1, 0x03020100}), "/////wABAgM=");
  EXPECT_EQ(base64_of({0, 0x7fffffff, 0}), "AAAAAP///38AAAAA");
}

TEST(MeshView, ElementsAreThoseOfTheMesh) {
  Subject subject = finding("dc-implies-as.case", "");
  const Mesh& mesh = subject.mesh().mesh();
  const Json json = subject.json();
  ASSERT_EQ(json["elements"]["count"], mesh.elements.size());
  const Numbers table = decoded(json["elements"]["data"]);
  ASSERT_EQ(table.size(), 7 * mesh.elements.size());
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      EXPECT_EQ(table[7 * i + 2 * axis], mesh.elements[i].lower[axis]);
      EXPECT_EQ(table[7 * i + 2 * axis + 1], mesh.elements[i].upper[axis]);
    }
    EXPECT_EQ(table[7 * i + 6], mesh.levels[i]);
  }
}

TEST(MeshView, NodesAndVectorsAreThoseOfTheMesh) {
  Subject subject(read_case_file(kCases + "/paper/example-2.10-m4.case"));
  const TSplines& splines = subject.mesh().splines();
  const Json json = subject.json();
  ASSERT_EQ(json["nodes"]["count"], 25);
  const Numbers table = decoded(json["nodes"]["data"]);
  ASSERT_EQ(table.size(), 6U * 25U);
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      EXPECT_EQ(table[at(6 * node + axis)], splines.nodes[at(node)][at(axis)]);
      const auto vector = splines.index_vector(node, axis);
      EXPECT_EQ(json["vectors"][at(axis)][at(table[at(6 * node + 3 + axis)])], Numbers(vector.begin(), vector.end()));
    }
  }
}

// v = (2, 2, 2), w = (2, 2, 3); [1,2]^3 is cut at x = 3/2, and its upper half at y = 3/2; the domain is 4 x 4 x 5.
TEST(MeshView, HasTheViolatedPairExactly) {
  const Json json = finding("as-implies-dc.case", "dual-compatible").json();
  EXPECT_EQ(json["lines"][0], (Texts{"0", "1", "3/2", "2", "3", "4"}));
  EXPECT_EQ(json["lines"][2], (Texts{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(json["picked"], (Numbers{0, 1}));
  EXPECT_EQ(json["marks"]["nodes"], Json::parse(R"([{"name":"v","node":0},{"name":"w","node":1}])"));
  EXPECT_EQ(decoded(json["nodes"]["data"])[2], 2) << "z of v";
  EXPECT_EQ(decoded(json["nodes"]["data"])[8], 3) << "z of w";
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(vector_of_node(json, 0, axis), (Texts{"1", "3/2", "2", "3", "4"}));
    EXPECT_EQ(vector_of_node(json, 1, axis), (Texts{"0", "1", "2", "3", "4"}));
  }
  EXPECT_EQ(place_texts(json, json["active"][0], 2), (Texts{"2", "2"}));
  EXPECT_EQ(json["active"][2], (Numbers{2, 3}));
  EXPECT_EQ(json["says"], "the supports of v and w share volume, but their index vectors do not overlap along x and y");
}

// R_x = {5/2} x [2,3] x [4,6], R_y = [2,3] x {5/2} x [2,4]: see SliceGeometry.HasThePerturbedRegions.
TEST(MeshView, HasThePerturbedRegionsAndWhereTheyMeet) {
  const Json json = finding("dc-implies-as.case", "dc-implies-as").json();
  ASSERT_EQ(json["regions"][0].size(), 1U);
  ASSERT_EQ(json["regions"][1].size(), 1U);
  EXPECT_EQ(json["regions"][2].size(), 0U);
  EXPECT_EQ(place_texts(json, json["regions"][0][0], 2), (Texts{"5/2", "5/2", "2", "3", "4", "6"}));
  EXPECT_EQ(place_texts(json, json["regions"][1][0], 2), (Texts{"2", "3", "5/2", "5/2", "2", "4"}));
  EXPECT_EQ(json["marks"]["points"][0]["at"], (Texts{"5/2", "5/2", "4"}));
  EXPECT_EQ(json["picked"].size(), json["marks"]["nodes"].size());
  EXPECT_GE(json["picked"].size(), 2U);
}

// x has no lines at the active region's sides 2 and 10. The face at y = 5/2 is in the y-vectors of the nodes at x = 7
// and 8 alone, whose supports reach from 5 to 9 and from 6 to 11.
TEST(MeshView, EndsPerturbedRegionsAtTheActiveRegionWhereNoLineIs) {
  const std::vector<int> lines{0, 1, 3, 4, 5, 6, 7, 8, 9, 11, 12};
  std::string text = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 12 5 5\n";
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) {
        const auto add = [&](const std::string& lower, const std::string& upper) {
          text += "element " + std::to_string(lines[i]) + " " + lower + " " + std::to_string(z) + "  " +
                  std::to_string(lines[i + 1]) + " " + upper + " " + std::to_string(z + 1) + "\n";
        };
        const bool halved = lines[i] == 7 && y == 2 && z == 2;
        add(std::to_string(y), halved ? "5/2" : std::to_string(y + 1));
        if (halved) add("5/2", "3");
      }
    }
  }
  const Json json = of_text(text).json();
  ASSERT_EQ(json["regions"][1].size(), 1U);
  EXPECT_EQ(place_texts(json, json["regions"][1][0], 2), (Texts{"5", "10", "5/2", "5/2", "2", "3"}));
}

TEST(MeshView, NumbersTheElementsThatAWitnessNames) {
  Subject subject = of_text("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\nsubdivide 1 1 1\n");
  CoarserInPatchWitness witness;
  witness.element = {{{1, 1, 1}, {Rational(3, 2), 2, 2}}, 1};
  witness.coarser = {{{0, 0, 0}, {1, 1, 1}}, 0};
  witness.environment = {{0, 0, 0}, {4, 4, Rational(7, 3)}};
  const Witness any = witness;
  const Json json = Json::parse(mesh_view_json(subject.mesh(), &any));
  const Numbers table = decoded(json["elements"]["data"]);
  ASSERT_EQ(json["elements_picked"].size(), 2U) << "the environment is no element";
  const std::size_t first = json["elements_picked"][0];
  EXPECT_EQ(Numbers(table.begin() + 7 * static_cast<std::ptrdiff_t>(first),
                    table.begin() + 7 * static_cast<std::ptrdiff_t>(first + 1)),
            (Numbers{1, 2, 1, 2, 1, 2, 1}));
  EXPECT_EQ(json["marks"]["boxes"][2]["upper"], (Texts{"4", "4", "7/3"}));
}

TEST(MeshView, SaysWhatThereIsNot) {
  const Json narrow = of_text("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 3\n").json();
  EXPECT_TRUE(narrow["active"].is_null());
  EXPECT_EQ(narrow["nodes"]["count"], 0);
  EXPECT_EQ(narrow["nodes"]["data"], "");
  EXPECT_EQ(narrow["picked"], Json::array());
  const Json one = of_text("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\nelement 0 0 0  4 4 4\n").json();
  EXPECT_EQ(one["active"], Json::parse(R"([["2","2"],["2","2"],["2","2"]])")) << "no line runs at 2";
  EXPECT_EQ(decoded(one["elements"]["data"]).back(), -6) << "m^6 unit cubes";
}

// On the line through (2, 2, 2) along x there is nothing on the left but the domain's side.
TEST(MeshView, HasNoVectorsWhereSomeDoNotExist) {
  Subject subject = of_text(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n"
      "element 0 0 0  2 2 2\nelement 2 0 0  4 2 2\nelement 0 2 0  2 4 2\nelement 2 2 0  4 4 2\n"
      "element 0 0 2  2 2 4\nelement 2 0 2  4 2 4\nelement 0 2 2  2 4 4\nelement 2 2 2  4 4 4\n");
  ASSERT_TRUE(subject.mesh().splines().missing.has_value());
  const Json json = subject.json();
  EXPECT_EQ(json["nodes"]["count"], 1);
  EXPECT_EQ(decoded(json["nodes"]["data"]), (Numbers{1, 1, 1, -1, -1, -1}));
  EXPECT_EQ(json["vectors"], Json::parse("[[],[],[]]"));
  EXPECT_TRUE(json["regions"].is_null());
}

TEST(MeshView, LeavesTheRegionsOfLargeMeshesOut) {
  const std::string head = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 20 20 ";
  EXPECT_TRUE(of_text(head + "50\n").json()["regions"].is_array());
  EXPECT_TRUE(of_text(head + "51\n").json()["regions"].is_null());
}

TEST(MeshView, LeavesTheRegionsOutBeyondTheBudget) {
  Subject subject = finding("dc-implies-as.case", "");
  subject.mesh().pair_budget = 1;
  EXPECT_TRUE(subject.json()["regions"].is_null());
}

TEST(MeshView, IsSafeInAScriptAndAlwaysTheSame) {
  Subject subject = of_text("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n");
  const Witness hostile = ClaimWitness{"kind", "</script><b>", {{"<i>", ExactPoint{1, 2, 3}}}};
  const std::string text = mesh_view_json(subject.mesh(), &hostile);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["says"], "</script><b>");
  EXPECT_EQ(text, mesh_view_json(subject.mesh(), &hostile));
  EXPECT_EQ(finding("as-implies-dc.case", "dual-compatible").text(),
            finding("as-implies-dc.case", "dual-compatible").text());
}

TEST(MeshView, TheScriptAndTheStyleAreSafeInAPage) {
  EXPECT_EQ(mesh_view_script().find("</"), std::string_view::npos);
  EXPECT_EQ(mesh_view_style().find("</"), std::string_view::npos);
  EXPECT_EQ(mesh_view_script().find("http"), std::string_view::npos) << "no network";
  EXPECT_NE(mesh_view_script().find("figure.mesh-view"), std::string_view::npos);
  EXPECT_NE(mesh_view_style().find("@media print"), std::string_view::npos);
}

}  // namespace
}  // namespace asts::testing
