#include "tests/minimize/rapidcheck_shrink.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Cases = rc::Seq<Case>;

/// Marks beyond the domain are moved onto its sides.
Case clamped(Case test_case) {
  for (Step& step : test_case.steps) {
    for (Point& mark : step.marks) {
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const Rational end = test_case.domain[axis];
        if (mark[axis].value() > end) mark[axis] = CompactRational(end);
      }
    }
  }
  return test_case;
}

Cases fewer_steps(const Case& test_case) {
  return rc::seq::map(rc::shrink::removeChunks(test_case.steps), [=](std::vector<Step> steps) {
    Case result = test_case;
    result.steps = std::move(steps);
    return result;
  });
}

/// One number of a case towards the least that it may have, in steps of `stride`.
template <class Set>
Cases towards(const Case& test_case, int value, int least, int stride, const Set& set) {
  return rc::seq::map(rc::shrink::towards((value - least) / stride, 0), [=](int steps) {
    Case result = test_case;
    set(result, least + steps * stride);
    return clamped(std::move(result));
  });
}

Cases smaller_numbers(const Case& test_case) {
  Cases all = towards(test_case, test_case.grading, 2, 1, [](Case& to, int m) { to.grading = m; });
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    all = rc::seq::concat(std::move(all), towards(test_case, test_case.degree[axis], 3, 2,
                                                  [axis](Case& to, int degree) { to.degree[axis] = degree; }));
    if (test_case.explicit_mesh) continue;
    all = rc::seq::concat(std::move(all), towards(test_case, test_case.domain[axis], 1, 1,
                                                  [axis](Case& to, int side) { to.domain[axis] = side; }));
  }
  return all;
}

/// A fraction with a smaller numerator, or a smaller denominator that leaves it where it is or nearer to 0.
rc::Seq<CompactRational> shrink_coordinate(const CompactRational& coordinate) {
  if (!coordinate.is_small()) return {};
  const std::int64_t numerator = coordinate.numerator();
  const std::int64_t denominator = coordinate.denominator();
  const auto fraction = [](std::int64_t above, std::int64_t below) { return CompactRational(Rational(above) / below); };
  return rc::seq::concat(rc::seq::map(rc::shrink::towards(numerator, std::int64_t{0}),
                                      [=](std::int64_t above) { return fraction(above, denominator); }),
                         rc::seq::map(rc::shrink::towards(denominator, std::int64_t{1}), [=](std::int64_t below) {
                           return fraction(numerator * below / denominator, below);
                         }));
}

rc::Seq<Point> shrink_point(const Point& point) {
  rc::Seq<Point> all;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    all = rc::seq::concat(std::move(all),
                          rc::seq::map(shrink_coordinate(point[axis]), [=](const CompactRational& coordinate) {
                            Point result = point;
                            result[axis] = coordinate;
                            return result;
                          }));
  }
  return all;
}

/// Fewer marks, but for none, then each mark.
rc::Seq<Step> shrink_step(const Step& step) {
  const auto with = [=](std::vector<Point> marks) { return Step{step.kind, std::move(marks)}; };
  return rc::seq::concat(rc::seq::map(rc::seq::filter(rc::shrink::removeChunks(step.marks),
                                                      [](const std::vector<Point>& marks) { return !marks.empty(); }),
                                      with),
                         rc::seq::map(rc::shrink::eachElement(step.marks, shrink_point), with));
}

Cases shrinks_of(const Case& test_case) {
  const auto with = [=](std::vector<Step> steps) {
    Case result = test_case;
    result.steps = std::move(steps);
    return result;
  };
  return rc::seq::concat(fewer_steps(test_case), smaller_numbers(test_case),
                         rc::seq::map(rc::shrink::eachElement(test_case.steps, shrink_step), with));
}

bool fails_safely(const std::function<bool(const Case&)>& fails, const Case& test_case) {
  try {
    return fails(test_case);
  } catch (const ResourceError&) {
    return false;
  }
}

}  // namespace

rc::Shrinkable<Case> shrinkable_case(const Case& test_case) {
  return rc::shrinkable::shrinkRecur(test_case, [](const Case& one) { return shrinks_of(one); });
}

rc::Gen<Case> same_case(const Case& test_case) {
  return {[=](const rc::Random&, int) { return shrinkable_case(test_case); }};
}

Shrunk shrink_with_rapidcheck(const Case& start, const std::function<bool(const Case&)>& fails, std::int64_t cap) {
  Shrunk result{start, 0, false};
  const auto counted = [&](const Case& candidate) {
    if (result.evaluations == cap) {
      result.stopped = true;
      return false;
    }
    ++result.evaluations;
    return fails_safely(fails, candidate);
  };
  result.smallest = rc::shrinkable::findLocalMin(same_case(start)(rc::Random(), 0), counted).first;
  return result;
}

}  // namespace asts
