#include "cli/trial_chain.hpp"

#include <gtest/gtest.h>

#include <unordered_map>

#include "lib/mesh/case_file.hpp"
#include "lib/mesh/fingerprint.hpp"
#include "lib/mesh/reflection.hpp"

namespace asts::cli {
namespace {

/// The paper's smallest scope with violations of as-implies-dc: 3401 meshes.
const Enumeration kEveryMesh{{{3, 3, 3}, 2, {4, 4, 5}}, 2, false, false};

std::vector<MeshStatement> statements() {
  std::vector<MeshStatement> result;
  for (const Property& property : all_properties()) result.push_back(statement_of(property));
  for (const char* id : {"as-implies-dc", "dc-implies-as"}) result.push_back(statement_of(*find_claim(id)));
  return result;
}

std::vector<const MeshStatement*> pointers_to(const std::vector<MeshStatement>& statements) {
  std::vector<const MeshStatement*> result;
  for (const MeshStatement& statement : statements) result.push_back(&statement);
  return result;
}

using Results = std::vector<TrialResult>;
using ByMesh = std::unordered_map<Fingerprint, Results, FingerprintHash>;

/// Each mesh decided by itself, as if there were no other.
ByMesh plainly(const Enumeration& enumeration, const std::vector<MeshStatement>& statements) {
  ByMesh decided;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& visited) {
    MeshUnderTest mesh(visited.tree);
    Results& results = decided[fingerprint_of(mesh.mesh())];
    for (const MeshStatement& statement : statements) {
      const Trial trial = statement.decide(mesh);
      results.push_back({trial.verdict.outcome, trial.met});
    }
  });
  return decided;
}

/// The fingerprints of a mesh's reflections, its own among them; some may be equal.
std::vector<Fingerprint> images_of(const RefinementTree& tree) {
  std::vector<Fingerprint> images{fingerprint_of(mesh_of(tree))};
  for (const PerAxis<bool>& axes : reflections()) images.push_back(fingerprint_of(mesh_of(reflect(tree, axes).tree)));
  return images;
}

void expect_equal(const Results& results, const Results& expected, const EnumeratedMesh& mesh) {
  ASSERT_EQ(results.size(), expected.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].outcome, expected[i].outcome) << i << '\n' << write_case(case_of(mesh));
    EXPECT_EQ(results[i].met, expected[i].met) << i << '\n' << write_case(case_of(mesh));
  }
}

// What spares work changes no verdict: neither on the mesh nor on those that it stands for.
TEST(TrialChain, HasTheVerdictsOfEachMeshDecidedByItself) {
  const std::vector<MeshStatement> tried = statements();
  const ByMesh expected = plainly(kEveryMesh, tried);
  EXPECT_EQ(expected.size(), 3401U);
  for (const bool up_to_reflection : {false, true}) {
    Enumeration enumeration = kEveryMesh;
    enumeration.up_to_reflection = up_to_reflection;
    TrialChain chain(pointers_to(tried));
    std::int64_t meshes = 0;
    enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) {
      meshes += mesh.reflections;
      const Results& results = chain.results(mesh);
      if (!up_to_reflection) return expect_equal(results, expected.at(fingerprint_of(mesh_of(mesh.tree))), mesh);
      for (const Fingerprint& image : images_of(mesh.tree)) expect_equal(results, expected.at(image), mesh);
    });
    EXPECT_EQ(meshes, 3401);
  }
}

// The test above would say little if all verdicts were alike.
TEST(TrialChain, TheScopeHasBothVerdicts) {
  std::int64_t violated = 0;
  for (const auto& [mesh, results] : plainly(kEveryMesh, {statement_of(*find_claim("as-implies-dc"))})) {
    violated += results.front().outcome == Outcome::violated ? 1 : 0;
  }
  EXPECT_EQ(violated, 8);
}

}  // namespace
}  // namespace asts::cli
