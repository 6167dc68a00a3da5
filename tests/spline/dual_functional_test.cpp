#include "lib/spline/dual_functional.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

using Vector = std::vector<Rational>;

Rational ratio(int a, int b) { return Rational(a) / Rational(b); }

Vector mapped(const Vector& x, const Rational& a, const Rational& b) {
  Vector result;
  for (const Rational& entry : x) result.push_back(a * entry + b);
  std::sort(result.begin(), result.end());
  return result;
}

/// Entries on the grid of step 1/4 with gaps of one to four steps: pairs meet inside each other's spans.
Vector any_vector(int p) {
  Vector x{ratio(*rc::gen::inRange(0, 9), 4)};
  for (int i = 1; i < p + 2; ++i) x.push_back(x.back() + ratio(*rc::gen::inRange(1, 5), 4));
  return x;
}

/// p+2 consecutive entries of a random knot line: any two such vectors overlap.
Vector consecutive(const Vector& line, int p, std::size_t first) {
  const auto begin = line.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + p + 2};
}

TEST(VectorsOverlap, ByHand) {
  EXPECT_TRUE(vectors_overlap(Vector{0, 1, 2}, Vector{0, 1, 2}));
  EXPECT_TRUE(vectors_overlap(Vector{0, 1, 2}, Vector{1, 2, 3}));
  EXPECT_TRUE(vectors_overlap(Vector{0, 1, 2}, Vector{5, 6, 7})) << "no entry lies in the other's span";
  EXPECT_TRUE(vectors_overlap(Vector{0, 1, 2}, Vector{2, 3, 4})) << "they share the entry they touch in";
  EXPECT_FALSE(vectors_overlap(Vector{0, 1, 2}, Vector{0, 2, 3})) << "1 is missing on the right";
  EXPECT_FALSE(vectors_overlap(Vector{0, 2, 3}, Vector{0, 1, 2})) << "and on the left";
  EXPECT_FALSE(vectors_overlap(Vector{0, 1, 3}, Vector{2, 4, 5})) << "2 lies between 1 and 3";
  EXPECT_FALSE(vectors_overlap(Vector{0, 1, 9}, Vector{2, 3, 4})) << "nested spans without a common entry";
}

TEST(PerfectAntiderivative, WeightsAreTheReciprocalProducts) {
  // G(u) just right of y_0 and the closed weights rest on w_j * product of (y_j - y_i) = 1.
  for (int p = 1; p <= 15; p += 2) {
    DualFunctional functional(p);
    const auto& y = functional.nodes();
    for (std::size_t j = 0; j < y.size(); ++j) {
      FieldElement product(functional.field(), Rational(Integer(1) << p) / Rational(p + 1));
      if (j % 2 == 1) product *= Rational(-1);
      if (j == 0 || j + 1 == y.size()) product /= Rational(2);
      for (std::size_t i = 0; i < y.size(); ++i) {
        if (i != j) product *= y[j] - y[i];
      }
      EXPECT_EQ(product, Rational(1)) << "p = " << p << ", j = " << j;
    }
  }
}

TEST(PerfectAntiderivative, IsZeroLeftAndOneRightOfTheSupport) {
  for (int p = 1; p <= 15; p += 2) {
    DualFunctional functional(p);
    EXPECT_EQ(functional.perfect_antiderivative(-1), Rational(0));
    EXPECT_EQ(functional.perfect_antiderivative(-5), Rational(0));
    EXPECT_EQ(functional.perfect_antiderivative(1), Rational(1));
    EXPECT_EQ(functional.perfect_antiderivative(5), Rational(1));
    EXPECT_EQ(functional.perfect_antiderivative(0), ratio(1, 2)) << "the perfect B-spline is even";
  }
}

TEST(PerfectAntiderivative, IntegralOfThePerfectBSplineIsOne) {
  // The formula for G, continued to u = 1 where the short cut does not answer: sum of w_j (1 - y_j)^(p+1).
  for (int p = 1; p <= 15; p += 2) {
    DualFunctional functional(p);
    const FieldElement one(functional.field(), Rational(1));
    FieldElement sum = power(one - functional.nodes()[0], static_cast<unsigned>(p + 1)) / Rational(2);
    for (int j = 1; j <= p; ++j) {
      const FieldElement distance = one - functional.nodes()[static_cast<std::size_t>(j)];
      sum += power(distance, static_cast<unsigned>(p + 1)) * Rational(j % 2 == 0 ? 1 : -1);
    }
    EXPECT_EQ(sum * Rational(Integer(1) << p) / Rational(p + 1), Rational(1)) << p;
  }
}

TEST(PerfectAntiderivative, ValuesByHand) {
  DualFunctional linear(1);  // B* is the hat on [-1, 0, 1]
  EXPECT_EQ(linear.perfect_antiderivative(ratio(-1, 2)), ratio(1, 8));
  EXPECT_EQ(linear.perfect_antiderivative(ratio(1, 2)), ratio(7, 8));
  DualFunctional cubic(3);  // 2 ((5/4)^4/2 - (1/4 + s)^4 + (1/4)^4), s = sqrt(1/2)
  const FieldElement root = cosine(cubic.field(), 1, 4) * Rational(2);
  EXPECT_EQ(cubic.perfect_antiderivative(ratio(1, 4)),
            FieldElement(cubic.field(), ratio(401, 256)) - root * ratio(9, 16));
}

RC_GTEST_PROP(PerfectAntiderivative, Law5IncreasesAndIsSymmetric, ()) {
  DualFunctional functional(2 * *rc::gen::inRange(0, 8) + 1);
  const Rational u = ratio(*rc::gen::inRange(-16, 17), 16);
  const Rational v = u + ratio(*rc::gen::inRange(1, 9), 64);
  const FieldElement at_u = functional.perfect_antiderivative(u);
  RC_ASSERT(at_u + functional.perfect_antiderivative(-u) == Rational(1));
  RC_ASSERT(u >= 1 || at_u < functional.perfect_antiderivative(v));
}

RC_GTEST_PROP(DualFunctional, Law1DeltaOnOverlappingVectors, ()) {
  const int p = 2 * *rc::gen::inRange(0, 8) + 1;
  DualFunctional functional(p);
  const auto size = static_cast<std::size_t>(2 * p + 5);
  Vector line{0};
  while (line.size() < size) line.push_back(line.back() + ratio(*rc::gen::inRange(1, 100), *rc::gen::inRange(1, 9)));
  const Vector x = consecutive(line, p, *rc::gen::inRange<std::size_t>(0, size - static_cast<std::size_t>(p) - 1));
  for (std::size_t first = 0; first + static_cast<std::size_t>(p) + 2 <= size; ++first) {
    const Vector x_tilde = consecutive(line, p, first);
    RC_ASSERT(vectors_overlap(x, x_tilde));
    RC_ASSERT(functional.lambda(x, x_tilde) == Rational(x == x_tilde ? 1 : 0));
  }
}

TEST(DualFunctional, Law1DeltaOnEveryOverlappingPairOfASmallGrid) {
  DualFunctional functional(1);
  int overlapping = 0, others = 0;
  std::vector<Vector> vectors;
  for (int a = 0; a < 7; ++a) {
    for (int b = a + 1; b < 7; ++b) {
      for (int c = b + 1; c < 7; ++c) vectors.push_back({a, b, c});
    }
  }
  for (const Vector& x : vectors) {
    for (const Vector& x_tilde : vectors) {
      const bool is_delta = functional.lambda(x, x_tilde) == Rational(x == x_tilde ? 1 : 0);
      const bool overlap = vectors_overlap(x, x_tilde);
      EXPECT_TRUE(is_delta || !overlap);
      ++(overlap ? overlapping : others);
    }
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(others, 100);
}

TEST(DualFunctional, NonOverlappingVectorsByHand) {
  DualFunctional linear(1);
  // D^2(G(u) u) = 3u+2 left and 2-3u right of 0 with u = x-1; against the hat with its top at u = -1/2 that makes
  // 0 on [-1, -1/2], 1/2 on [-1/2, 0], 1/3 on [0, 1].
  EXPECT_EQ(linear.lambda(Vector{0, 1, 2}, Vector{0, ratio(1, 2), 2}), ratio(5, 6));

  DualFunctional cubic(3);
  // Of X~ only 5/2 makes a term: u = 1/4, (5/2-1)(5/2-2)(5/2-3) = -3/8, the product over i != k is -15/16, the length
  // is 3: (-3/8) * 3 / (-15/16) = 6/5 times G(1/4) = 401/256 - (9/16) sqrt(2).
  const FieldElement root = cosine(cubic.field(), 1, 4) * Rational(2);
  EXPECT_EQ(cubic.lambda(Vector{0, 1, 2, 3, 4}, Vector{0, 1, 2, ratio(5, 2), 3}),
            FieldElement(cubic.field(), ratio(1203, 640)) - root * ratio(27, 40));
}

RC_GTEST_PROP(DualFunctional, Law2AffineInvariance, ()) {
  const int p = 2 * *rc::gen::inRange(0, 4) + 1;
  const Vector x = any_vector(p), x_tilde = any_vector(p);
  const Rational a = ratio(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20)) * *rc::gen::element(1, -1);
  const Rational b = ratio(*rc::gen::inRange(-20, 20), 7);
  DualFunctional functional(p), fresh(p);  // two objects: the kept values rest on the law that is tested here
  RC_ASSERT(functional.lambda(x, x_tilde) == fresh.lambda(mapped(x, a, b), mapped(x_tilde, a, b)));
}

TEST(DualFunctional, Law3ZeroWithoutCommonInterior) {
  DualFunctional cubic(3);
  EXPECT_EQ(cubic.lambda(Vector{0, 1, 2, 3, 4}, Vector{4, 5, 6, 7, 8}), Rational(0));
  EXPECT_EQ(cubic.lambda(Vector{4, 5, 6, 7, 8}, Vector{0, 1, 2, 3, 4}), Rational(0));
  EXPECT_EQ(cubic.lambda(Vector{0, 1, 2, 3, 4}, Vector{ratio(9, 2), 5, 6, 7, 8}), Rational(0));
}

TEST(DualFunctional, KeptValuesAreTheFirstOnes) {
  DualFunctional cubic(3);
  const Vector x{0, 1, 2, 3, 4}, x_tilde{0, 1, 2, ratio(5, 2), 3};
  const FieldElement first = cubic.lambda(x, x_tilde);
  EXPECT_EQ(cubic.lambda(x, x_tilde), first);
  EXPECT_NE(cubic.lambda(x_tilde, x), first) << "the pair is ordered";
  EXPECT_EQ(cubic.kept(), 2U);
  EXPECT_EQ(cubic.lambda(mapped(x, 3, -7), mapped(x_tilde, 3, -7)), first);
  EXPECT_EQ(cubic.lambda(mapped(x, ratio(1, 9), ratio(1, 2)), mapped(x_tilde, ratio(1, 9), ratio(1, 2))), first);
  EXPECT_EQ(cubic.kept(), 2U) << "one value for all affine images of a pair";
}

TEST(DualFunctional, AHugeDegreeIsRationalOnOverlappingVectors) {
  DualFunctional functional(1001);
  Vector x;
  for (int i = 0; i < 1003; ++i) x.push_back(i);
  EXPECT_EQ(functional.lambda(x, x), Rational(1));
  EXPECT_EQ(functional.lambda(x, mapped(x, 1, 1)), Rational(0));
}

TEST(DualFunctional, RefusesWhatIsNoIndexVector) {
  EXPECT_THROW(DualFunctional(2), InputError);
  EXPECT_THROW(DualFunctional(0), InputError);
  EXPECT_THROW(DualFunctional(-1), InputError);
  DualFunctional linear(1);
  const Vector good{0, 1, 2};
  for (const Vector& bad : {Vector{0, 1}, Vector{0, 1, 2, 3}, Vector{0, 0, 1}, Vector{2, 1, 0}, Vector{}}) {
    EXPECT_THROW(linear.lambda(good, bad), InputError);
    EXPECT_THROW(linear.lambda(bad, good), InputError);
  }
}

}  // namespace
}  // namespace asts
