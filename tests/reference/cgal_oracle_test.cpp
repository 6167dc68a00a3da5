#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/reference/suitability.hpp"

namespace asts::reference {
namespace {

using Kernel = CGAL::Cartesian<CGAL::Gmpq>;

struct BothForms {
  BasicBox<Grid> box;
  Kernel::Iso_cuboid_3 cuboid;
};

/// Corners in {0..4}^3, so that touching, equal and disjoint boxes are all frequent.
BothForms random_box(std::mt19937_64& random) {
  BasicBox<Grid> box{};
  for (std::size_t a = 0; a < dimension; ++a) {
    box.lower[a] = static_cast<Grid>(random() % 4);
    box.upper[a] = box.lower[a] + 1 + static_cast<Grid>(random() % static_cast<unsigned>(4 - box.lower[a]));
  }
  const auto corner = [](const std::array<Grid, dimension>& c) {
    return Kernel::Point_3(CGAL::Gmpq(static_cast<int>(c[0])), CGAL::Gmpq(static_cast<int>(c[1])),
                           CGAL::Gmpq(static_cast<int>(c[2])));
  };
  return {box, Kernel::Iso_cuboid_3(corner(box.lower), corner(box.upper))};
}

// The closed-box test against CGAL's exact one; both count touching boxes as meeting.
TEST(ReferenceOracle, ClosedBoxesMeetAsInCgal) {
  std::mt19937_64 random(17);
  int meeting = 0, touching = 0;
  for (int round = 0; round < 5000; ++round) {
    const BothForms first = random_box(random), second = random_box(random);
    const bool meet = closed_intersection(first.box, second.box).has_value();
    EXPECT_EQ(meet, CGAL::do_intersect(first.cuboid, second.cuboid));
    meeting += meet;
    touching += meet && !intersect_with_volume(first.box, second.box);
  }
  EXPECT_GT(touching, 500);
  EXPECT_LT(meeting, 4900);
}

}  // namespace
}  // namespace asts::reference
