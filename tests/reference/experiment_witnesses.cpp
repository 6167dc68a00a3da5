#include <algorithm>

#include "tests/reference/complexity_checks.hpp"
#include "tests/reference/corner_experiment.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

Setting experiment_setting(int m) { return {{3, 3, 3}, m, {5, 5, 5}}; }

/// The limits that the repaired claim states, for m = 2, ..., 5.
constexpr std::int64_t limits[] = {3840, 1680, 1152, 924};

int read_grading(const json& value) {
  const std::size_t m = read_count(value, "m");
  if (m < 2 || m > 5) throw Rejected("m is not 2, 3, 4 or 5");
  return static_cast<int>(m);
}

RootSum printed_bound(int m) { return complexity_constant(experiment_setting(m)) * (Rational(1) / 3000); }

RootSum limit_bound(int m) { return {m, Rational(limits[m - 2])}; }

/// From when on the meshes repeat themselves, m times smaller: every step n > start + 3 adds what step n - 3 does.
struct Repetition {
  int start;
  std::vector<std::int64_t> counts;  ///< |G_n \ G_0| for n = 0, ..., start + 3
};

/// From here on the meshes are known to repeat themselves, for m = 2 later than for the others.
int latest_start(int m) { return m == 2 ? 21 : 17; }

std::optional<Repetition> repetition_from(int m, int start) {
  if (start < 0 || start > latest_start(m)) return std::nullopt;
  for (std::int64_t window = 4; window > 0; --window)
    if (corner_repeats(experiment_setting(m), start, window))
      return Repetition{start, corner_counts(experiment_setting(m), start + 3)};
  return std::nullopt;
}

/// What a step of each residue adds from step start + 1 on.
std::array<std::int64_t, 3> growth_of(const Repetition& found) {
  std::array<std::int64_t, 3> growth{};
  for (std::size_t i = 0; i < 3; ++i)
    growth[i] = found.counts[found.counts.size() - 3 + i] - found.counts[found.counts.size() - 4 + i];
  return growth;
}

/// |G_n \ G_0| for any n.
Integer count_after(const Repetition& found, const Integer& n) {
  const Integer known = found.counts.size() - 1;
  if (n <= known) return found.counts[static_cast<std::size_t>(n)];
  const std::array<std::int64_t, 3> growth = growth_of(found);
  const Integer more = n - known, periods = more / 3, rest = more % 3;
  Integer count = found.counts.back() + periods * (growth[0] + growth[1] + growth[2]);
  for (std::size_t i = 0; i < 3 && Integer(i) < rest; ++i) count += growth[i];
  return count;
}

/// Once they repeat themselves, they do from any later step on.
Repetition latest_repetition(int m) {
  if (const auto found = repetition_from(m, latest_start(m))) return *found;
  throw Rejected("the meshes are not seen to repeat themselves within " + std::to_string(latest_start(m)) + " steps");
}

Integer count_after(int m, std::size_t steps) {
  if (steps <= 20) return Integer(corner_counts(experiment_setting(m), static_cast<int>(steps)).back());
  return count_after(latest_repetition(m), Integer(steps));
}

/// Each of the steps marks the element in one and the same corner of the domain, and nothing else. After n steps its
/// level is n.
void require_experiment(const ClaimSubject& subject) {
  const Setting& setting = subject.setting();
  const Setting own = experiment_setting(setting.grading);
  if (setting.degree != own.degree || setting.domain != own.domain || setting.grading > 5)
    throw Rejected("the setting is not the experiment's");
  if (subject.steps() == nullptr) throw Rejected("the claim is about sequences of steps");
  std::vector<std::array<bool, dimension>> corners;
  for (unsigned bits = 0; bits < 8; ++bits) corners.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0});
  Box element = initial_mesh(setting).front();
  for (std::size_t n = 0; n < subject.steps()->size(); ++n) {
    const LiteralStep& step = (*subject.steps())[n];
    if (!step.refine || step.marks.empty()) throw Rejected("a step does not call refine for one element");
    std::erase_if(corners, [&](const std::array<bool, dimension>& high) {
      return !std::all_of(step.marks.begin(), step.marks.end(), [&](const Point& mark) {
        for (std::size_t a = 0; a < dimension; ++a) {
          const Rational from_corner = high[a] ? Rational(setting.domain[a] - mark[a]) : mark[a];
          const bool inside = high[a] ? from_corner <= element.upper[a] : from_corner < element.upper[a];
          if (from_corner < 0 || !inside) return false;
        }
        return true;
      });
    });
    if (corners.empty()) throw Rejected("the steps do not mark one corner's element again and again");
    element = subdivide_along(setting, element, n % 3).front();
  }
}

/// New elements for so many marks, one a step, against the bound for each.
std::string compared(int m, const Integer& steps, const Integer& count, const RootSum& bound) {
  const Rational ratio = Rational(count) / Rational(steps);
  if (sign(RootSum{m, ratio} - bound) < 0)
    throw Rejected("the ratio is below the bound: " + count.str() + "/" + steps.str() + " < " + text(bound));
  return "m = " + std::to_string(m) + ": " + count.str() + " new elements for " + steps.str() + " marks are " +
         text(ratio) + " a mark, not below " + text(bound) + ".";
}

std::string check_sequence(ClaimSubject& subject, const json& witness, RootSum (*bound_of)(int), const char* name) {
  const json& values = values_of(witness, {"steps", "new elements", "ratio", name});
  require_experiment(subject);
  const int m = subject.setting().grading;
  const std::size_t steps = read_count(values["steps"], "steps");
  if (steps == 0 || steps > subject.steps()->size())
    throw Rejected("there are not so many steps, or none is asked for");
  const Integer count = count_after(m, steps);
  const RootSum bound = bound_of(m);
  require_equal(Rational(read_count(values["new elements"], "new elements")), Rational(count), "the new elements");
  require_equal(read_number(values["ratio"]), Rational(count) / Rational(steps), "the ratio");
  require_equal(read_root_sum(values[name], m, name), bound, name);
  return "Every step marks the same corner's element. " + compared(m, Integer(steps), count, bound);
}

/// A step at which the ratio is not below the bound. That it is the first is not asked: one is enough.
std::string check_first_step(const json& witness, RootSum (*bound_of)(int), const char* name) {
  const json& values = values_of(witness, {"m", "first step", "limit of the ratio", "n_0 of the certificate", name});
  const int m = read_grading(values["m"]);
  const auto start = static_cast<int>(std::min<std::size_t>(read_count(values["n_0 of the certificate"], "n_0"), 1000));
  const auto found = repetition_from(m, start);
  if (!found) throw Rejected("the meshes are not seen to repeat themselves from that step on");
  const std::array<std::int64_t, 3> growth = growth_of(*found);
  require_equal(read_number(values["limit of the ratio"]), Rational(growth[0] + growth[1] + growth[2]) / 3,
                "the limit of the ratio");
  const RootSum bound = bound_of(m);
  require_equal(read_root_sum(values[name], m, name), bound, name);
  const Rational first = read_number(values["first step"]);
  if (denominator(first) != 1 || first < 1) throw Rejected("first step: no step");
  const Integer step = numerator(first);
  return "The meshes repeat themselves from step " + std::to_string(start) + " on. " +
         compared(m, step, count_after(*found, step), bound);
}

std::string check_any(ClaimSubject& subject, const json& witness, RootSum (*bound_of)(int), const char* name) {
  return subject.is_none() ? check_first_step(witness, bound_of, name)
                           : check_sequence(subject, witness, bound_of, name);
}

}  // namespace

std::string check_ratio(ClaimSubject& subject, const json& witness) {
  return check_any(subject, witness, printed_bound, "C/3000");
}

std::string check_ratio_repaired(ClaimSubject& subject, const json& witness) {
  return check_any(subject, witness, limit_bound, "limit stated");
}

std::string check_other_limit(ClaimSubject&, const json& witness) {
  const json& values = values_of(witness, {"m", "limit stated", "late steps", "C/2849"});
  const int m = read_grading(values["m"]);
  const std::int64_t limit = limits[m - 2];
  require_equal(read_count(values["limit stated"], "limit stated"), static_cast<std::size_t>(limit),
                "the limit stated");
  const std::array<std::int64_t, 3> growth = growth_of(latest_repetition(m));
  require_equal(read_point(values["late steps"]), Point{growth[0], growth[1], growth[2]}, "what late steps add");
  const RootSum bound = complexity_constant(experiment_setting(m)) * (Rational(1) / 2849);
  require_equal(read_root_sum(values["C/2849"], m, "C/2849"), bound, "C/2849");
  const bool certified = std::all_of(growth.begin(), growth.end(), [&](std::int64_t one) { return one == limit; });
  if (certified && sign(bound - RootSum{m, Rational(limit)}) > 0)
    throw Rejected("late steps add " + std::to_string(limit) + ", below C/2849 = " + text(bound));
  return "m = " + std::to_string(m) + ": late steps add " + text(Point{growth[0], growth[1], growth[2]}) +
         "; stated is " + std::to_string(limit) + ", and C/2849 = " + text(bound) + ".";
}

}  // namespace asts::reference
