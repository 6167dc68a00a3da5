#include "lib/minimize/exhaust.hpp"

#include <algorithm>

#include "lib/exact/rational.hpp"
#include "lib/minimize/path_search.hpp"

namespace asts {

namespace {

/// Calls `visit` for every setting of the scope until it returns false.
template <class Visit>
bool for_each_setting(const Scope& scope, Visit visit) {
  const auto side_of = [&](std::int64_t taken) { return static_cast<int>(scope.volume / taken); };
  Setting setting;
  for (int x = 1; x <= side_of(1); ++x) {
    for (int y = 1; y <= side_of(x); ++y) {
      for (int z = 1; z <= side_of(std::int64_t{x} * y); ++z) {
        setting.domain = {x, y, z};
        for (setting.grading = 2; setting.grading <= scope.grading; ++setting.grading) {
          setting.degree = {3, 3, 3};
          for (bool more = true; more;) {
            if (!visit(setting)) return false;
            std::size_t axis = 0;
            while (axis < kDimension && (setting.degree[axis] += 2) > scope.degree) setting.degree[axis++] = 3;
            more = axis < kDimension;
          }
        }
      }
    }
  }
  return true;
}

std::int64_t volume_of(const Setting& setting) {
  std::int64_t volume = 1;
  for (const int side : setting.domain) volume *= side;
  return volume;
}

/// n/(n+mj) binomial(n+mj, j): the meshes of exactly j subdivisions.
Integer meshes_of(std::int64_t cubes, int grading, int subdivisions) {
  const std::int64_t places = cubes + std::int64_t{grading} * subdivisions;
  Integer product = cubes;
  for (int i = 1; i < subdivisions; ++i) product *= places - i;
  for (int i = 1; i <= subdivisions; ++i) product /= i;
  return subdivisions == 0 ? Integer(1) : product;
}

/// For a larger m the scope ends with the case's own degree, volume and m: meshes of that many elements take long.
constexpr int kMostSurrounded = 16;

/// What proves nothing is tried with less patience.
constexpr std::int64_t kLessIfIncomplete = 10;

/// Two cases of bare steps by the order of CaseSize and compare_numbers.
class Smallest {
 public:
  Smallest(const Case& smallest, const CaseSize& size) : smallest_(smallest), size_(size) {}

  void offer(const EnumeratedMesh& mesh) {
    const PathCase paths = mesh_paths(case_of(mesh)).value();
    const CaseSize size = size_of_mesh(paths);
    if (size > size_) return;
    Case written = case_of(paths);
    if (size == size_ && compare_numbers(written, smallest_) >= 0) return;
    smallest_ = std::move(written);
    size_ = size;
    found_ = true;
  }

  std::optional<Case> found() const { return found_ ? std::optional(smallest_) : std::nullopt; }

 private:
  Case smallest_;
  CaseSize size_;
  bool found_ = false;
};

}  // namespace

std::string scope_text(const Scope& scope) {
  const auto range = [](int first, int last) {
    return first == last ? std::to_string(first) : std::to_string(first) + " to " + std::to_string(last);
  };
  return "every mesh of at most " + std::to_string(scope.subdivisions) + " subdivisions on domains of at most " +
         std::to_string(scope.volume) + " cubes, degrees " + range(3, scope.degree) +
         ", m = " + range(2, scope.grading);
}

std::optional<std::int64_t> count_meshes(const Scope& scope, const Excluded& excluded, std::int64_t limit) {
  Integer total = 0;
  const bool within = for_each_setting(scope, [&](const Setting& setting) {
    if (excluded(setting)) return true;
    for (int j = 0; j <= scope.subdivisions; ++j) total += meshes_of(volume_of(setting), setting.grading, j);
    return total <= limit;
  });
  if (!within) return std::nullopt;
  return static_cast<std::int64_t>(total);
}

std::optional<ChosenScope> choose_scope(const Case& smallest, const CaseSize& size, const Excluded& excluded,
                                        std::int64_t limit) {
  const int degree = *std::max_element(smallest.degree.begin(), smallest.degree.end());
  const int m = smallest.grading;
  for (std::int64_t subdivisions = std::min<std::int64_t>(size.subdivisions, 64); subdivisions >= 0; --subdivisions) {
    const int k = static_cast<int>(subdivisions);
    std::vector<Scope> scopes{{k, size.volume, degree, m}};
    if (m <= kMostSurrounded) {
      scopes.insert(scopes.begin(), {{k, 2 * size.volume, degree + 2, m + 1}, {k, size.volume, degree + 2, m + 1}});
    }
    for (const Scope& scope : scopes) {
      const bool complete = subdivisions == size.subdivisions;
      if (count_meshes(scope, excluded, complete ? limit : limit / kLessIfIncomplete)) {
        return ChosenScope{scope, complete};
      }
    }
  }
  return std::nullopt;
}

Exhausted exhaust(const Scope& scope, const Case& smallest, const CaseSize& size, bool up_to_reflection,
                  const Excluded& excluded, const std::function<MeshTrial()>& new_trial) {
  Exhausted result;
  Smallest best(smallest, size);
  for_each_setting(scope, [&](const Setting& setting) {
    if (excluded(setting)) {
      ++result.excluded;
      return true;
    }
    const MeshTrial trial = new_trial();
    enumerate_meshes({setting, scope.subdivisions, false, up_to_reflection}, [&](const EnumeratedMesh& mesh) {
      result.meshes += mesh.reflections;
      if (!trial(mesh)) return;
      result.violating += mesh.reflections;
      best.offer(mesh);
    });
    return true;
  });
  result.smaller = best.found();
  return result;
}

}  // namespace asts
