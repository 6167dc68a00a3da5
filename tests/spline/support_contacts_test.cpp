#include "lib/spline/support_contacts.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

SupportContacts contacts_of(const std::string& text) {
  const TSplines splines = tsplines_of(last_mesh(parse_case(text, "case")));
  return count_contacts(splines, bricks_of(splines));
}

/// Pair by pair, from the definition.
SupportContacts compare_all(const TSplines& splines) {
  SupportContacts contacts;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for (std::int32_t w = 0; w < v; ++w) {
      std::size_t dimension = 0;
      bool meet = true;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval one = splines.support(v, axis);
        const RankInterval other = splines.support(w, axis);
        meet = meet && one.lower <= other.upper && other.lower <= one.upper;
        dimension += interiors_meet(one, other) ? 1 : 0;
      }
      contacts.by_dimension[dimension] += meet ? 1 : 0;
    }
  }
  return contacts;
}

// Uniform, p = 3: supports are 4 long. Nodes at 2, 3, 4, 5, 6 along z alone: the pair (2, 6) touches in the face z = 4,
// the nine others share volume.
TEST(SupportContacts, FacesOfALine) {
  EXPECT_EQ(contacts_of("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 8\n").by_dimension,
            (std::array<std::int64_t, 4>{0, 0, 1, 9}));
}

// Nodes at 2, ..., 6 along x and y: along an axis 1 of 5 * 5 ordered pairs touches each way, 23 share an interval.
// Ordered pairs: in an edge 2 * 2 = 4, in a face 2 * 2 * 23 = 92, in volume 23 * 23 = 529, of these 25 with itself.
TEST(SupportContacts, EdgesOfAPlane) {
  EXPECT_EQ(contacts_of("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 8 8 4\n").by_dimension,
            (std::array<std::int64_t, 4>{0, 2, 46, 252}));
}

// The same in three dimensions: 2 * 2 * 2 ordered pairs in a point, 3 * 2 * 2 * 23 in an edge, 3 * 2 * 23 * 23 in a
// face.
TEST(SupportContacts, PointsOfABox) {
  EXPECT_EQ(contacts_of("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 8 8 8\n").by_dimension,
            (std::array<std::int64_t, 4>{4, 138, 1587, (23 * 23 * 23 - 125) / 2}));
}

TEST(SupportContacts, AgreeWithAllPairs) {
  Draw draw(20);
  CaseLimits limits;
  limits.max_side = 9;
  for (int i = 0; i < 600; ++i) {
    const Case content = i % 3 == 0   ? random_admissible_case(draw, limits).content
                         : i % 3 == 1 ? random_bare_case(draw, limits).content
                                      : random_box_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    const TSplines splines = tsplines_of(last_mesh(content));
    if (splines.size() == 0 || splines.missing) continue;
    ASSERT_EQ(count_contacts(splines, bricks_of(splines)), compare_all(splines));
  }
}

}  // namespace
}  // namespace asts
