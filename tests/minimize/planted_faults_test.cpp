#include "tests/minimize/planted_faults.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {
namespace {

TEST(PlantedFaults, StartsViolateThroughTheFaultAlone) {
  for (const PlantedFault& fault : planted_faults()) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Case start = fault.start(seed);
      EXPECT_TRUE(fault.predicate(start)) << fault.name << "\n" << write_case(start);
      EXPECT_FALSE(violation_without_fault(fault, start)) << fault.name << "\n" << write_case(start);
      EXPECT_GE(size_of(start), kLeastStartSize) << fault.name;
      for (const int side : start.domain) EXPECT_LE(side, kLargestStartSide) << fault.name;
    }
    EXPECT_EQ(fault.start(1), fault.start(1)) << fault.name;
    EXPECT_NE(fault.start(1), fault.start(2)) << fault.name;
  }
}

TEST(PlantedFaults, AreNotInTheInitialMesh) {
  const Case initial{{3, 5, 3}, 2, {6, 6, 6}, {}, false, {}};
  for (const PlantedFault& fault : planted_faults()) EXPECT_FALSE(fault.predicate(initial)) << fault.name;
}

const PlantedFault& fault_named(const std::string& name) {
  for (const PlantedFault& fault : planted_faults()) {
    if (name == fault.name) return fault;
  }
  throw std::out_of_range(name);
}

/// The element at the origin is subdivided so many times.
Case at_origin(int subdivisions) {
  Case result{{3, 3, 3}, 2, {1, 1, 1}, {}, false, {}};
  result.steps.assign(static_cast<std::size_t>(subdivisions), {Step::Kind::subdivide, {Point{}}});
  return result;
}

// By hand: level 6 is the first with two splits along z, and needs six subdivisions.
TEST(PlantedFaults, AreWhereTheyArePlanted) {
  const PlantedFault& levels = fault_named("level-of-few-splits");
  EXPECT_FALSE(levels.predicate(at_origin(5)));
  EXPECT_EQ(levels.predicate(at_origin(6)), "other-size");
  const PlantedFault& late = fault_named("late-index-vector");
  const auto on_five = [](const char* steps) {
    return parse_case(std::string("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 5 5\n") + steps, "five");
  };
  EXPECT_FALSE(late.predicate(on_five("subdivide 5/2 5/2 5/2\n")));
  EXPECT_EQ(late.predicate(on_five("subdivide 5/2 5/2 5/2\nsubdivide 9/4 5/2 5/2\n")), "not-in-the-middle");
  const PlantedFault& overlaps = fault_named("overlap-along-all-axes");
  EXPECT_EQ(overlaps.predicate(on_five("refine 5/2 3/2 5/2\n")), "no-overlap");
  EXPECT_FALSE(overlaps.predicate(on_five("refine 1/2 1/2 1/2\n")));
}

}  // namespace
}  // namespace asts
