#include "lib/refine/self_similarity.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {
namespace {

constexpr Setting kExperiment{{3, 3, 3}, 3, {5, 5, 5}};

Setting experiment(int grading) { return {{3, 3, 3}, grading, {5, 5, 5}}; }

/// G_0, G_1, ... with the closures A_1, A_2, ... that lead to them (A_0 is empty).
struct Sequence {
  std::vector<RefinementTree> meshes;
  std::vector<std::vector<std::int32_t>> closures{{}};

  Sequence(const Setting& setting, std::size_t steps) {
    RefinementTree tree(setting);
    meshes.push_back(tree);
    while (closures.size() <= steps) {
      const std::int32_t mark = tree.leaf_at(Point{});
      closures.push_back(refine(tree, std::span(&mark, 1)));
      meshes.push_back(tree);
    }
  }
};

// The conclusion of the proof, looked at far beyond the certificate: closures have the same sizes every third step,
// meshes are scaled copies, and the counts that the certificate foretells are those of the meshes.
TEST(SelfSimilarity, ForetellsWhatLaterStepsDo) {
  for (int m = 2; m <= 5; ++m) {
    const auto certificate = find_self_similarity(experiment(m), 40);
    ASSERT_TRUE(certificate) << m;
    const auto start = static_cast<std::size_t>(certificate->start);
    const Sequence sequence(experiment(m), start + 15);
    for (std::size_t n = 0; n < sequence.meshes.size(); ++n) {
      EXPECT_EQ(new_elements_after(*certificate, static_cast<std::int64_t>(n)), sequence.meshes[n].new_element_count())
          << m << ", step " << n;
    }
    for (std::size_t n = start; n + 3 < sequence.meshes.size(); ++n) {
      EXPECT_TRUE(is_scaled_copy(sequence.meshes[n], sequence.meshes[n + 3], certificate->window)) << m << ' ' << n;
      if (n == start) continue;
      EXPECT_EQ(sequence.closures[n].size(), sequence.closures[n + 3].size()) << m << ' ' << n;
    }
  }
}

TEST(SelfSimilarity, OfThePapersExperiment) {
  const std::vector<std::pair<int, std::int64_t>> growth{{2, 3840}, {3, 1680}, {4, 1152}, {5, 924}};
  for (const auto& [m, expected] : growth) {
    const auto certificate = find_self_similarity(experiment(m), 40);
    ASSERT_TRUE(certificate) << m;
    EXPECT_EQ(certificate->growth, (PerAxis<std::int64_t>{expected, expected, expected})) << m;
  }
}

TEST(SelfSimilarity, IsFoundNoEarlierThanItIsTrue) {
  const auto certificate = find_self_similarity(kExperiment, 40);
  ASSERT_TRUE(certificate);
  EXPECT_EQ(certificate->start, 13);
  EXPECT_EQ(certificate->window, 4);
  EXPECT_FALSE(find_self_similarity(kExperiment, 15)) << "needs step 16 to compare with step 13";
  const Sequence sequence(kExperiment, 16);
  EXPECT_FALSE(looks_inside(sequence.meshes[13], sequence.closures[13], 4)) << "so n_0 = 12 does not do";
  EXPECT_TRUE(looks_inside(sequence.meshes[14], sequence.closures[14], 4));
  EXPECT_FALSE(is_scaled_copy(sequence.meshes[0], sequence.meshes[3], 4)) << "unit cubes are left in [0,4/3]^3";
  EXPECT_FALSE(is_scaled_copy(sequence.meshes[13], sequence.meshes[15], 4)) << "two steps are no period";
}

// One subdivision more or less anywhere in the window is seen.
TEST(SelfSimilarity, ACopyWithOneDifferenceIsNone) {
  const Sequence sequence(kExperiment, 16);
  RefinementTree changed = sequence.meshes[16];
  ASSERT_TRUE(is_scaled_copy(sequence.meshes[13], changed, 4));
  const auto point = [](int top, int bottom) { return CompactRational(Rational(top) / Rational(bottom)); };
  changed.subdivide(changed.leaf_at({point(9, 2), point(9, 2), point(9, 2)}));
  changed.update_ranks();
  EXPECT_TRUE(is_scaled_copy(sequence.meshes[13], changed, 4)) << "outside the image of the window";
  changed.subdivide(changed.leaf_at({point(5, 4), point(5, 4), point(5, 4)}));
  changed.update_ranks();
  EXPECT_FALSE(is_scaled_copy(sequence.meshes[13], changed, 4)) << "inside [0,4/3]^3";
}

// Degree 3, unit cubes of [0,5]^3: the environment of the corner cube ends at 1 + 4 = 5, that of its first half along
// x, of level 1, at 1/2 + 4/2 = 5/2 along x and at 5 along y and z.
TEST(SelfSimilarity, LooksInsideByHand) {
  RefinementTree tree({{3, 3, 3}, 2, {8, 8, 8}});
  const std::int32_t cube = tree.leaf_at(Point{});
  EXPECT_FALSE(looks_inside(tree, {cube}, 5)) << "level 0";
  tree.subdivide(cube);
  tree.update_ranks();
  const std::int32_t half = tree.leaf_at(Point{});
  EXPECT_TRUE(looks_inside(tree, {half}, 5));
  EXPECT_FALSE(looks_inside(tree, {half}, 4));
}

TEST(SelfSimilarity, CountsByTheCertificate) {
  const SelfSimilarity certificate{1, 1, {0, 5, 6, 7, 9}, {10, 20, 40}};
  EXPECT_EQ(new_elements_after(certificate, 0), 0);
  EXPECT_EQ(new_elements_after(certificate, 4), 9);
  EXPECT_EQ(new_elements_after(certificate, 5), 19);
  EXPECT_EQ(new_elements_after(certificate, 6), 39);
  EXPECT_EQ(new_elements_after(certificate, 7), 79);
  EXPECT_EQ(new_elements_after(certificate, 8), 89);
  EXPECT_THROW(new_elements_after(certificate, -1), InputError);
}

}  // namespace
}  // namespace asts
