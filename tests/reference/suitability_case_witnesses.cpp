#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/suitability_cases.hpp"
#include "tests/reference/suitability_kinds.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

// ---- the table, which no mesh is needed for

std::string listed(const std::vector<int>& cases) {
  std::string result;
  for (const int number : cases) result += (result.empty() ? "" : ", ") + std::to_string(number);
  return result.empty() ? "none" : result;
}

std::string situation_text(const std::array<bool, 4>& v) {
  const char* questions[] = {"v1 in N_y(r)", "v2 in N_y(r)", "v3 in N_x(q)", "v4 in N_x(q)"};
  std::string result;
  for (std::size_t i = 0; i < v.size(); ++i)
    result += std::string(i == 0 ? "" : ", ") + questions[i] + ": " + (v[i] ? "true" : "false");
  return result;
}

/// A comparison of JSON values here makes g++ 12 warn of bounds that are kept.
std::array<bool, 4> read_situation(const json& value) {
  const std::string given = value.is_string() ? value.get<std::string>() : std::string();
  for (unsigned bits = 0; bits < 16; ++bits) {
    const std::array<bool, 4> v{(bits & 8) != 0, (bits & 4) != 0, (bits & 2) != 0, (bits & 1) != 0};
    if (given == situation_text(v)) return v;
  }
  throw Rejected("situation is none of the 16");
}

/// The cases that the table lists, read with its printed heads for v3 and v4 (true, false by assumption) or as asked.
std::vector<int> printed_row(const std::array<bool, 4>& v, bool printed_heads) {
  std::string heads;
  for (const bool head : {v[0], v[1], printed_heads || v[2], !printed_heads && v[3]}) heads += head ? 'T' : 'F';
  for (const PrintedCases& row : printed_cases())
    if (row.heads == heads) return row.cases;
  throw Rejected("the table has no row " + heads);
}

std::string check_row(const json& witness, bool printed_heads) {
  const json& values = values_of(witness, {"situation", "listed", "applying", "situations", "wrong"});
  const std::array<bool, 4> v = read_situation(values["situation"]);
  const std::string row = listed(printed_row(v, printed_heads));
  const std::string applying = listed(applying_cases(v[0], v[1], v[2], v[3]));
  if (values["listed"] != row) throw Rejected("listed: the table's row has " + row);
  if (values["applying"] != applying) throw Rejected("applying: those that apply are " + applying);
  if (row == applying && row != "none") throw Rejected("the row lists the cases that apply: nothing is violated");
  if (read_count(values["situations"], "situations") != 16) throw Rejected("there are 16 situations");
  const int wrong = wrong_rows(printed_heads);
  if (read_count(values["wrong"], "wrong") != static_cast<std::size_t>(wrong))
    throw Rejected("wrong: recounted, there are " + std::to_string(wrong));
  return "In the situation " + situation_text(v) + " the table's row lists " + row + "; the cases that apply are " +
         applying + ". Recounted: " + std::to_string(wrong) + " of the 16 situations are wrong.";
}

// ---- the cases in a mesh

struct Quadruple {
  std::size_t x, y;  ///< the axes
  Rational q, r;
  std::array<ActiveNode<Rational>, 4> v;
};

Quadruple read_quadruple(const Space<Rational>& space, const json& values) {
  Quadruple result{read_axis(values["first_axis"]),
                   read_axis(values["second_axis"]),
                   read_number(values["first_slice"]),
                   read_number(values["second_slice"]),
                   {}};
  if (result.x == result.y) throw Rejected("both slices are across the same axis");
  const char* names[] = {"v1", "v2", "v3", "v4"};
  for (std::size_t i = 0; i < 4; ++i) result.v[i] = checked_active_node(space, values[names[i]], names[i]);
  return result;
}

/// The situation of the proof: v1 in N_x(q), v2 not, v3 in N_y(r), v4 not, and the box of common points of the four
/// supports and both slices of AR.
BasicBox<Rational> check_quadruple(const Space<Rational>& space, const Quadruple& s) {
  const auto expect = [&](std::size_t number, std::size_t axis, const Rational& q, bool in) {
    if (in_slice_nodes(space, axis, q, s.v[number - 1].node) != in)
      throw Rejected("v" + std::to_string(number) + (in ? " is not in " : " is in ") + slice_name(axis, q));
  };
  expect(1, s.x, s.q, true);
  expect(2, s.x, s.q, false);
  expect(3, s.y, s.r, true);
  expect(4, s.y, s.r, false);
  BasicBox<Rational> line = space.active;
  line.lower[s.x] = line.upper[s.x] = s.q;
  line.lower[s.y] = line.upper[s.y] = s.r;
  std::optional<BasicBox<Rational>> common = closed_intersection(space.active, line);
  for (const ActiveNode<Rational>& v : s.v)
    if (common) common = closed_intersection(*common, v.support);
  if (!common)
    throw Rejected("the supports of v1, v2, v3, v4 have no common point in both slices of the active region");
  return *common;
}

/// What is wrong with the pair of a case; empty if nothing.
std::string fault(const ActiveNode<Rational>& v, const ActiveNode<Rational>& w, bool asks_volume) {
  if (partially_overlap(v, w)) {
    std::string axes;
    for (std::size_t a = 0; a < dimension; ++a)
      if (overlap(v.vectors[a], w.vectors[a]))
        axes += " " + described_vector(v, a) + " overlaps " + described_vector(w, a) + ".";
    return " they partially overlap:" + axes;
  }
  if (asks_volume && !intersect_with_volume(v.support, w.support))
    return " their supports " + text(as_box(v.support)) + " and " + text(as_box(w.support)) + " share no volume.";
  return "";
}

std::vector<int> cases_of(const Space<Rational>& space, const Quadruple& s) {
  const auto in_y = [&](std::size_t i) { return in_slice_nodes(space, s.y, s.r, s.v[i].node); };
  const auto in_x = [&](std::size_t i) { return in_slice_nodes(space, s.x, s.q, s.v[i].node); };
  return applying_cases(in_y(0), in_y(1), in_x(2), in_x(3));
}

std::string described_quadruple(const Quadruple& s, const BasicBox<Rational>& common) {
  std::string result = "Hypothesis: q = " + text(s.q) + " along " + axis_name(s.x) + ", r = " + text(s.r) + " along " +
                       axis_name(s.y) + ";";
  for (std::size_t i = 0; i < 4; ++i) result += " v" + std::to_string(i + 1) + " = " + described_node(s.v[i]) + ";";
  return result + " v1 is in " + slice_name(s.x, s.q) + ", v2 is not, v3 is in " + slice_name(s.y, s.r) +
         ", v4 is not; the supports have the common points " + text(as_box(common)) +
         " in both slices: two perturbed regions meet there.";
}

std::string check_case_in_mesh(ClaimSubject& subject, const json& witness, bool asks_volume) {
  const json& values =
      values_of(witness, {"first_axis", "first_slice", "second_axis", "second_slice", "v1", "v2", "v3", "v4"});
  const std::string exist = splines_exist(subject.setting(), subject.mesh());
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const Quadruple s = read_quadruple(space, values);
  const BasicBox<Rational> common = check_quadruple(space, s);
  const std::size_t pairs[5][2] = {{0, 1}, {0, 3}, {0, 2}, {1, 3}, {1, 2}};
  std::string faults;
  for (const int number : cases_of(space, s)) {
    const auto [v, w] = pairs[number - 1];
    const std::string wrong = fault(s.v[v], s.v[w], asks_volume);
    if (wrong.empty()) continue;
    faults += " Case " + std::to_string(number) + " applies, with the nodes " + text(s.v[v].node) + " and " +
              text(s.v[w].node) + ", but" + wrong;
  }
  if (faults.empty()) throw Rejected("every case that applies has its conclusion: nothing is violated");
  return described_quadruple(s, common) + exist + " Conclusion:" + faults;
}

}  // namespace

std::string check_case_table(ClaimSubject& /*subject*/, const json& witness) { return check_row(witness, true); }
std::string check_case_table_repaired(ClaimSubject& /*subject*/, const json& witness) {
  return check_row(witness, false);
}

std::string check_case(ClaimSubject& subject, const json& witness) {
  return check_case_in_mesh(subject, witness, true);
}
std::string check_case_repaired(ClaimSubject& subject, const json& witness) {
  return check_case_in_mesh(subject, witness, false);
}

std::string check_no_case(ClaimSubject& subject, const json& witness) {
  const json& values =
      values_of(witness, {"point", "first_axis", "first_slice", "second_axis", "second_slice", "v1", "v2", "v3", "v4"});
  splines_exist(subject.setting(), subject.mesh());
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const Quadruple s = read_quadruple(space, values);
  const BasicBox<Rational> common = check_quadruple(space, s);
  if (!in_closed(common, read_point(values["point"])))
    throw Rejected("the point is not among the common points " + text(as_box(common)));
  const std::vector<int> cases = cases_of(space, s);
  if (!cases.empty()) throw Rejected("nothing is violated: these cases of the proof apply: " + listed(cases));
  return described_quadruple(s, common) + " Conclusion: no case of the proof applies.";
}

}  // namespace asts::reference
