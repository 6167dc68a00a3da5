#include "tests/reference/corner_experiment.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

namespace asts::reference {

namespace {

/// Coordinates in units of m^-depth.
struct Cell {
  std::array<std::int64_t, 3> lower;
  int level;
  bool operator==(const Cell&) const = default;
  auto operator<=>(const Cell&) const = default;
};

struct Run {
  Setting setting;
  std::int64_t unit = 1;  ///< m^depth
  std::vector<Cell> mesh;
  std::vector<Cell> closure;                       ///< of the last step
  std::vector<std::array<std::int64_t, 3>> sizes;  ///< by level

  Run(const Setting& s, int steps) : setting(s) {
    if (steps > 24) throw std::invalid_argument("too many steps for whole numbers of 64 bits");
    for (int level = 0; level < steps + 3; level += 3) unit *= s.grading;
    for (int level = 0; level <= steps; ++level)
      sizes.push_back({size_of(level, 0), size_of(level, 1), size_of(level, 2)});
    for (const Box& cube : initial_mesh(s)) {
      Cell cell{{}, 0};
      for (std::size_t a = 0; a < 3; ++a) cell.lower[a] = static_cast<std::int64_t>(numerator(cube.lower[a])) * unit;
      mesh.push_back(cell);
    }
  }

  /// Equation "df size": as many divisions by m along x, y, z as levels 1, 2, 3 mod 3 have been passed.
  std::int64_t size_of(int level, int axis) const {
    std::int64_t result = unit;
    for (int passed = axis; passed < level; passed += 3) result /= setting.grading;
    return result;
  }

  std::int64_t size(int level, int axis) const {
    return sizes[static_cast<std::size_t>(level)][static_cast<std::size_t>(axis)];
  }

  /// Definition 2.4 in half units: does the closed `other` meet U(k)? D is (p + 3/2) sizes.
  bool in_patch(const Cell& k, const Cell& other) const {
    for (std::size_t a = 0; a < 3; ++a) {
      const int axis = static_cast<int>(a);
      const std::int64_t own = size(k.level, axis);
      const std::int64_t middle = 2 * k.lower[a] + own;
      const std::int64_t radius = (2 * setting.degree[a] + 3) * own;
      const std::int64_t lower = 2 * other.lower[a], upper = lower + 2 * size(other.level, axis);
      if (upper <= middle - radius || lower >= middle + radius) return false;
    }
    return true;
  }

  /// Upper end of U(K) along an axis, not cut off by the domain, in half units.
  std::int64_t reach(const Cell& k, std::size_t a) const {
    const std::int64_t own = size(k.level, static_cast<int>(a));
    return 2 * k.lower[a] + own + (2 * setting.degree[a] + 3) * own;
  }

  void step() {
    closure = {*std::find_if(mesh.begin(), mesh.end(), [](const Cell& k) {
      return k.lower == std::array<std::int64_t, 3>{0, 0, 0};
    })};
    std::set<Cell> marked(closure.begin(), closure.end());
    for (std::size_t i = 0; i < closure.size(); ++i) {
      const Cell k = closure[i];
      for (const Cell& other : mesh) {
        if (other.level >= k.level || !in_patch(k, other)) continue;
        if (marked.insert(other).second) closure.push_back(other);
      }
    }
    std::vector<Cell> refined;
    for (const Cell& k : mesh) {
      if (!marked.contains(k)) {
        refined.push_back(k);
        continue;
      }
      const auto axis = static_cast<std::size_t>(k.level % 3);
      for (int j = 0; j < setting.grading; ++j) {
        Cell child{k.lower, k.level + 1};
        child.lower[axis] += j * size(k.level + 1, k.level % 3);
        refined.push_back(child);
      }
    }
    mesh = std::move(refined);
  }

  /// The elements in [0,end]^3, end in units.
  std::set<Cell> inside(std::int64_t end) const {
    std::set<Cell> result;
    for (const Cell& k : mesh) {
      bool in = true;
      for (int a = 0; a < 3; ++a) in = in && k.lower[static_cast<std::size_t>(a)] + size(k.level, a) <= end;
      if (in) result.insert(k);
    }
    return result;
  }

  bool looks_inside(std::int64_t end) const {
    for (const Cell& k : closure)
      for (std::size_t a = 0; a < 3; ++a)
        if (k.level == 0 || reach(k, a) > 2 * end) return false;
    return true;
  }
};

}  // namespace

std::vector<std::int64_t> corner_counts(const Setting& setting, int steps) {
  Run run(setting, steps);
  std::vector<std::int64_t> counts{0};
  for (int step = 1; step <= steps; ++step) {
    run.step();
    counts.push_back(std::count_if(run.mesh.begin(), run.mesh.end(), [](const Cell& k) { return k.level > 0; }));
  }
  return counts;
}

bool corner_repeats(const Setting& setting, int start, std::int64_t window) {
  Run run(setting, start + 3);
  for (int step = 1; step <= start; ++step) run.step();
  std::set<Cell> image;
  for (Cell k : run.inside(window * run.unit)) {
    for (std::int64_t& coordinate : k.lower) coordinate /= setting.grading;  // exact: the unit is fine enough
    k.level += 3;
    image.insert(k);
  }
  for (int step = 1; step <= 3; ++step) {
    run.step();
    if (!run.looks_inside(window * run.unit)) return false;
  }
  return run.inside(window * run.unit / setting.grading) == image;
}

}  // namespace asts::reference
