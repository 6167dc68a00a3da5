#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

const std::string kFindings = case_path("../../reports/findings/");

/// What VTK finds in a file (tests/cli/read_vtu.py).
Json read_by_vtk(const std::string& path) {
  const std::string command = ASTS_VTK_PYTHON " '" + case_path("../cli/read_vtu.py") + "' '" + path + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot be started: " + command);
  std::string text;
  char buffer[4096];
  for (std::size_t size; (size = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, size);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return Json::parse(text);
}

/// A case with what the program says about its last mesh and what VTK reads.
struct Exported {
  int exit_code;
  Json check;   ///< asts check --final --format json
  Json counts;  ///< asts export --format json, the last line
  Json vtk;
};

Exported exported(const std::string& case_text, const Names& options = {}) {
  const TemporaryFolder folder;
  const std::string case_file = folder.write("mesh.case", case_text);
  const std::string out = folder.path("mesh.vtu");
  Names arguments{"export", case_file, "-o", out, "--format", "json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.err, "");
  const Outcome check = run({"check", "--final", "--property", "admissible", "--format", "json", case_file});
  return {outcome.exit_code, records_of(check.out).at(0), records_of(outcome.out).back(), read_by_vtk(out)};
}

std::int64_t count_of(const Json& tally, const std::string& key) {
  return tally.contains(key) ? tally[key].get<std::int64_t>() : 0;
}

/// What holds for every grid.
void expect_as_checked(const Exported& grid) {
  const Json& check = grid.check;
  const Json& vtk = grid.vtk;
  const auto elements = check["elements"].get<std::int64_t>();
  const auto nodes = check["active_nodes"].get<std::int64_t>();
  EXPECT_EQ(count_of(vtk["kinds"], "0"), elements);
  EXPECT_EQ(count_of(vtk["kinds"], "1"), nodes);
  EXPECT_EQ(count_of(vtk["kinds"], "3"), grid.counts.value("samples", 0));
  EXPECT_EQ(count_of(vtk["types"], "11"), elements + grid.counts.value("samples", 0)) << "voxels";
  EXPECT_EQ(count_of(vtk["types"], "1"), nodes + grid.counts["witness_points"].get<std::int64_t>()) << "vertices";
  EXPECT_EQ(vtk["crooked_voxels"], 0);
  EXPECT_EQ(vtk["cells"], grid.counts["cells"]);
  EXPECT_EQ(vtk["points"], grid.counts["points"]);
  EXPECT_EQ(vtk["field_data"]["elements"]["range"], (Json{elements, elements}));
  EXPECT_EQ(vtk["field_data"]["active_nodes"]["range"], (Json{nodes, nodes}));
  for (const auto& [name, array] : vtk["cell_data"].items()) EXPECT_EQ(array["tuples"], vtk["cells"]) << name;
  for (const auto& [name, array] : vtk["point_data"].items()) EXPECT_EQ(array["tuples"], vtk["points"]) << name;
  const Json& level = vtk["cell_data"]["level"];
  EXPECT_EQ(level["range"][1], check["max_level"].get<double>());
  EXPECT_EQ(level["vtk_range"], level["range"]) << "VTK leaves NaN out of it";
  EXPECT_EQ(vtk["point_data"]["node"]["range"], (Json{-1, nodes - 1}));
}

TEST(ExportCommand, ADeepMesh) {
  const Names corner{"generate", "corner", "--grading", "16", "--domain", "5,5,5", "--elements", "40000"};
  const Exported grid = exported(run(corner).out, {"--node", "2,2,2"});
  EXPECT_EQ(grid.exit_code, 0);
  expect_as_checked(grid);
  EXPECT_GT(grid.check["max_level"].get<int>(), 60);
  EXPECT_EQ(grid.vtk["bounds"], Json::parse("[0.0, 5.0, 0.0, 5.0, 0.0, 5.0]"));
  EXPECT_EQ(grid.vtk["volumes"]["0"].get<double>(), 125) << "powers of two: float64 has them all";
  EXPECT_EQ(grid.vtk["point_data"]["node"]["range"], (Json{-1, 7}));
}

TEST(ExportCommand, AMillionElements) {
  const Outcome workload = run({"generate", "sphere", "--elements", "1000000"});
  const Exported grid = exported(workload.out);
  EXPECT_EQ(grid.exit_code, 0);
  expect_as_checked(grid);
  EXPECT_GE(grid.check["elements"].get<std::int64_t>(), 1'000'000);
  EXPECT_EQ(grid.vtk["volumes"]["0"].get<double>(), 16 * 16 * 16);
}

TEST(ExportCommand, AnEmptyActiveRegion) {
  const Exported grid =
      exported("asts-case 1\ndegree 5 5 5\ngrading 3\ndomain 4 5 4\nrefine 0 0 0\n", {"--perturbed-regions"});
  EXPECT_EQ(grid.exit_code, 0);
  expect_as_checked(grid);
  EXPECT_EQ(grid.vtk["types"].size(), 1U) << "no vertices";
  EXPECT_EQ(grid.vtk["point_data"]["node"]["range"], (Json{-1, -1}));
  EXPECT_EQ(grid.counts["perturbed_elements"], (Json{0, 0, 0}));
  EXPECT_NEAR(grid.vtk["volumes"]["0"].get<double>(), 80, 1e-9);
}

// The cubic B-spline on 5 integers is 1/6, 2/3, 1/6 at the inner ones, so B_v is 8/27 at v; its integral is 1.
TEST(ExportCommand, ABlendingFunction) {
  const Exported grid = exported(kHeader, {"--node", "2,2,2"});
  expect_as_checked(grid);
  EXPECT_EQ(grid.counts["support_elements"], 64);
  EXPECT_EQ(grid.counts["samples"], 16 * 16 * 16);
  EXPECT_EQ(grid.vtk["cell_data"]["support"]["nonzero"], Json::parse(R"({"0":64,"1":0,"3":4096})"));
  const Json& value = grid.vtk["point_data"]["value"];
  EXPECT_NEAR(value["range"][1].get<double>(), 8.0 / 27, 1e-15);
  EXPECT_EQ(value["range"][0].get<double>(), 0);
  // values at integers sum up to 1; at quarters, 4^3 times as many, to 64
  EXPECT_NEAR(value["sum"].get<double>(), 1 + 64, 1e-12);
  EXPECT_EQ(grid.vtk["field_data"]["chosen_node"]["sum"].get<double>(), 6);
  EXPECT_EQ(grid.vtk["field_data"]["vectors_x"]["components"], 5);
  EXPECT_EQ(grid.vtk["volumes"]["3"].get<double>(), 64) << "the lattice covers the support";
}

TEST(ExportCommand, AViolatedPropertyIsMarked) {
  const std::string text = content_of(kFindings + "dc-implies-as.case");
  const Exported grid = exported(text, {"--property", "analysis-suitable"});
  EXPECT_EQ(grid.exit_code, 1);
  expect_as_checked(grid);
  const Json& words = grid.vtk["field_data"];
  EXPECT_EQ(words["statement"], Json{"analysis-suitable"});
  EXPECT_EQ(words["verdict"], Json{"violated"});
  EXPECT_EQ(words["witness_kind"], Json{"perturbed-regions-meet"});
  EXPECT_EQ(words["witness_points"], Json{"t"});
  EXPECT_EQ(grid.counts["witness_points"], 1);
  EXPECT_EQ(grid.vtk["point_data"]["witness"]["range"], (Json{0, words["witness_nodes"].size() + 1}));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("perturbed_") + "xyz"[axis];
    EXPECT_EQ(grid.vtk["cell_data"][name]["nonzero"]["0"], grid.counts["perturbed_elements"][axis]);
  }
}

TEST(ExportCommand, AViolatedElementIsMarked) {
  const std::string text =
      kHeader + "subdivide 1/2 1/2 1/2\nsubdivide 1/4 1/2 1/2\nsubdivide 1/4 1/4 1/2\nsubdivide 1/4 1/4 1/4\n";
  const Exported grid = exported(text, {"--property", "admissible"});
  EXPECT_EQ(grid.exit_code, 1);
  expect_as_checked(grid);
  EXPECT_EQ(grid.vtk["field_data"]["witness_boxes"], (Json{"E", "C", "U"}));
  EXPECT_EQ(grid.vtk["cell_data"]["witness"]["range"][1], 3);
  EXPECT_EQ(grid.vtk["cell_data"]["witness"]["nonzero"]["0"], grid.counts["witness_elements"]);
  EXPECT_GT(grid.counts["witness_elements"].get<int>(), 2);
}

TEST(ExportCommand, AnExplicitMeshWithAnElementWithoutLevel) {
  const Exported grid = exported(kHeader + "element 0 0 0  3 4 4\nelement 3 0 0  4 4 4\n");
  expect_as_checked(grid);
  EXPECT_EQ(grid.vtk["cell_data"]["level"]["nan"], 1) << "a volume of 48 is no power of two, one of 16 is";
  EXPECT_EQ(grid.vtk["cell_data"]["level"]["range"], (Json{-4.0, -4.0}));
}

TEST(ExportCommand, SpeaksToAPerson) {
  const TemporaryFolder folder;
  const std::string out = folder.path("a.vtu");
  const Outcome outcome = run({"export", "-", "-o", out, "--node", "2,2,2", "--property", "admissible"}, kHeader);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "admissible: holds\n" + out +
                             ": 4161 cells, 5038 points: 64 elements, 1 active nodes, 4096 cells of a lattice over the "
                             "support, which 64 elements share volume with\n");
}

TEST(ExportCommand, GivesTheSameBytesTwice) {
  const TemporaryFolder folder;
  const std::string bad = kFindings + "as-implies-dc.case";
  for (const char* name : {"one", "two"}) {
    EXPECT_EQ(run({"export", bad, "-o", folder.path(name), "--claim", "as-implies-dc"}).exit_code, 1);
  }
  EXPECT_EQ(content_of(folder.path("one")), content_of(folder.path("two")));
  EXPECT_GT(content_of(folder.path("one")).size(), 1000U);
}

TEST(ExportCommand, RefusesWrongInput) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.case", kHeader);
  const std::string bad = folder.write("bad.case", kHeader + "refine 0 0 9\n");
  const std::string out = folder.path("out.vtu");
  const std::vector<std::pair<Names, std::string>> wrong{
      {{bad, "-o", out}, "asts: " + bad + ":5: "},
      {{good, "-o", out, "--node", "1,1,1"}, "asts: " + good + ": (1, 1, 1) is no active node of the last mesh\n"},
      {{good, "-o", out, "--node", "9/2,2,2"}, "asts: " + good + ": (9/2, 2, 2) is no active node of the last mesh\n"},
      {{good, "-o", out, "--node", "2,2"}, "asts: --node takes three numbers: X,Y,Z\n"},
      {{good, "-o", out, "--node", "2,2,2,2"}, "asts: --node takes three numbers: X,Y,Z\n"},
      {{good, "-o", out, "--node", "2,2,0.5"}, "asts: --node 2,2,0.5: "},
      {{good, "-o", out, "--property", "none"}, "asts: no property is called 'none'\n"},
      {{good, "-o", out, "--property", "admissible", "--claim", "as-implies-dc"},
       "asts: one --claim or one --property"},
      {{good, "-o", folder.path("none/out.vtu")}, "asts: " + folder.path("none/out.vtu") + ": cannot be written\n"},
      {{good, "-o", folder.path("")}, "asts: " + folder.path("") + ": cannot be written: is a directory\n"},
      {{good, "-o", good}, "asts: " + good + ": is the case itself\n"},
      {{good}, "asts: --out is required\n"},
  };
  for (auto [arguments, reason] : wrong) {
    arguments.insert(arguments.begin(), "export");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << reason;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with(reason)) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
  const auto files = std::distance(std::filesystem::directory_iterator(folder.path("")), {});
  EXPECT_EQ(files, 2) << "nothing half written is left";
  EXPECT_EQ(content_of(good), kHeader);
}

}  // namespace
}  // namespace asts::testing
