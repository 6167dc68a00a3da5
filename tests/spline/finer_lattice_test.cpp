#include "lib/spline/finer_lattice.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"

namespace asts {
namespace {

Mesh mesh_of_text(const std::string& text) {
  const Case content = parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\n" + text, "f");
  return mesh_of(setting_of(content), content.elements);
}

/// A row along x with lines 0, 1, 2, and the same with 1/2 and 3/2 besides.
const char* const kRow = "domain 2 1 1\nelement 0 0 0 1 1 1\nelement 1 0 0 2 1 1\n";
const char* const kFinerRow =
    "domain 2 1 1\nelement 0 0 0 1/2 1 1\nelement 1/2 0 0 1 1 1\nelement 1 0 0 3/2 1 1\nelement 3/2 0 0 2 1 1\n";

// Law 1.
TEST(FinerLattice, KeepsCoordinates) {
  const Mesh mesh = mesh_of_text(kRow);
  const Mesh finer = mesh_of_text(kFinerRow);
  const FinerLattice lattice(mesh, finer);
  for (std::int32_t rank = 0; rank < 3; ++rank) {
    EXPECT_EQ(finer.coordinate(0, lattice.rank(0, rank)), mesh.coordinate(0, rank));
  }
  EXPECT_EQ(lattice.node({2, 1, 0}), (PerAxis<std::int32_t>{4, 1, 0}));
}

// Law 2: the open interval (0,1), half rank 1, becomes (0,1/2), {1/2}, (1/2,1): half ranks 1 to 3.
TEST(FinerLattice, KeepsSetsOfPoints) {
  const FinerLattice lattice(mesh_of_text(kRow), mesh_of_text(kFinerRow));
  EXPECT_EQ(lattice.box({{1, 0, 0}, {1, 0, 1}}), (Box{{1, 0, 0}, {3, 0, 1}}));
  EXPECT_EQ(lattice.box({{1, 1, 2}, {2, 1, 2}}), (Box{{1, 1, 2}, {4, 1, 2}}));
  EXPECT_EQ(lattice.box({{2, 0, 0}, {3, 2, 2}}), (Box{{4, 0, 0}, {7, 2, 2}}));
}

}  // namespace
}  // namespace asts
