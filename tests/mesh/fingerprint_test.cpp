#include "lib/mesh/fingerprint.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

Fingerprint fingerprint_of_text(const std::string& steps, const std::string& setting) {
  const Case content = parse_case("asts-case 1\n" + setting + steps, "test");
  if (content.explicit_mesh) return fingerprint_of(mesh_of(setting_of(content), content.elements));
  Replay replay(content);
  while (!replay.done()) replay.advance();
  return fingerprint_of(mesh_of(replay.tree()));
}

const std::string kSetting = "degree 3 3 3\ngrading 2\ndomain 2 1 1\n";

// Law 1: steps in another order, repeated marks, and boxes instead of steps.
TEST(Fingerprint, IsOfTheMeshAndNotOfItsHistory) {
  const Fingerprint one = fingerprint_of_text("subdivide 0 0 0\nsubdivide 1 0 0\n", kSetting);
  EXPECT_EQ(fingerprint_of_text("subdivide 1 0 0  0 0 0\n", kSetting), one);
  EXPECT_EQ(fingerprint_of_text("element 3/2 0 0 2 1 1\nelement 0 0 0 1/2 1 1\n"
                                "element 1 0 0 3/2 1 1\nelement 1/2 0 0 1 1 1\n",
                                kSetting),
            one);
  EXPECT_NE(fingerprint_of_text("subdivide 0 0 0\n", kSetting), one);
}

// Law 2 where it is easily broken: other setting, other coordinates of the same order, mirrored meshes.
TEST(Fingerprint, TellsMeshesApartThatLookAlike) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
  const auto add = [&](const std::string& steps, const std::string& setting) {
    const Fingerprint value = fingerprint_of_text(steps, setting);
    EXPECT_TRUE(seen.insert({value.high, value.low}).second) << setting << steps;
  };
  add("", kSetting);
  add("", "degree 3 3 3\ngrading 3\ndomain 2 1 1\n");
  add("", "degree 3 5 3\ngrading 2\ndomain 2 1 1\n");
  add("", "degree 5 3 3\ngrading 2\ndomain 2 1 1\n");
  add("", "degree 3 3 3\ngrading 2\ndomain 1 2 1\n");
  add("subdivide 0 0 0\n", kSetting);
  add("subdivide 1 0 0\n", kSetting);
  add("element 0 0 0 1/3 1 1\nelement 1/3 0 0 1 1 1\nelement 1 0 0 2 1 1\n", kSetting);
  add("element 0 0 0 1/36893488147419103232 1 1\nelement 1/36893488147419103232 0 0 1 1 1\nelement 1 0 0 2 1 1\n",
      kSetting);
  add("element 0 0 0 1/36893488147419103233 1 1\nelement 1/36893488147419103233 0 0 1 1 1\nelement 1 0 0 2 1 1\n",
      kSetting);
}

// Both laws on random meshes: the literal code's sorted boxes say which are equal.
TEST(Fingerprint, IsEqualExactlyForEqualMeshes) {
  std::map<std::string, Fingerprint> by_mesh;
  std::set<std::pair<std::uint64_t, std::uint64_t>> values;
  Draw draw(1);
  for (int round = 0; round < 600; ++round) {
    const CaseLimits limits{3, 2, 2, 8, 20, 2};
    const RandomCase random = round % 2 == 0 ? random_bare_case(draw, limits) : random_box_case(draw, limits);
    const Mesh mesh = [&] {
      if (random.content.explicit_mesh) return mesh_of(setting_of(random.content), random.content.elements);
      Replay replay(random.content);
      while (!replay.done()) replay.advance();
      return mesh_of(replay.tree());
    }();
    std::string key = testing::PrintToString(random.content.domain);
    for (const reference::Box& box : literal::sorted(literal::mesh(mesh))) {
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        key += " " + to_string(box.lower[axis]) + " " + to_string(box.upper[axis]);
      }
    }
    const Fingerprint value = fingerprint_of(mesh);
    EXPECT_EQ(by_mesh.try_emplace(key, value).first->second, value) << key;
    values.insert({value.high, value.low});
  }
  EXPECT_EQ(values.size(), by_mesh.size());
  EXPECT_LT(by_mesh.size(), 600U);  // some were repeated, so that law 1 was tried
}

}  // namespace
}  // namespace asts
