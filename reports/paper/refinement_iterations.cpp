#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lib/exact/errors.hpp"
#include "lib/refine/refinement.hpp"
#include "properties/claims/patch_relation.hpp"
#include "reports/paper/corner_view.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/picture.hpp"

namespace asts {

namespace {

const Rational kScale = 28;
constexpr std::size_t kPanelsInRow = 3;
constexpr std::size_t kIterations = 3;
constexpr std::array<const char*, kIterations> kColours{kVermilion, kOrange, kBlue};

/// In which iteration of Algorithm 2.8's loop each element of the closure came: 0 for the marked one. The loop goes
/// through the elements that were there when the iteration began.
using Iterations = std::map<std::int32_t, std::size_t>;

Iterations iterations_of(const RefinementTree& tree, std::int32_t mark) {
  const CoarserInPatches patches(tree);
  Iterations result{{mark, 0}};
  for (std::size_t iteration = 1; iteration <= kIterations; ++iteration) {
    const Iterations before = result;
    for (const auto& [element, number] : before) {
      for (const std::int32_t coarser : patches.of(element)) result.emplace(coarser, iteration);
    }
  }
  const auto last = std::count_if(result.begin(), result.end(), [](const auto& e) { return e.second == kIterations; });
  ensure(last == 0, "the third iteration does not change anything");
  return result;
}

std::size_t marked_after(const Iterations& iterations, std::size_t iteration) {
  const auto count =
      std::count_if(iterations.begin(), iterations.end(), [&](const auto& e) { return e.second <= iteration; });
  return static_cast<std::size_t>(count);
}

const char* colour_of(const Iterations& iterations, std::int32_t element, std::size_t iteration) {
  const auto found = iterations.find(element);
  return found == iterations.end() || found->second > iteration ? kPlain : kColours.at(found->second);
}

class Panels {
 public:
  Panels(Picture& picture, const PerAxis<int>& domain) : picture_(picture), domain_(domain) {}

  void draw(const RefinementTree& tree, const Paint& paint, const std::string& caption) {
    CornerView view{domain_, kScale, 0, 0};
    const auto row = static_cast<Px>(number_ / kPanelsInRow);
    const auto column = static_cast<Px>(number_ % kPanelsInRow);
    view.left = kPictureMargin + column * (view.width() + px(40));
    view.top = Picture::top() + row * (view.height() + px(70));
    XmlNode group = add_group(picture_.svg(), "mesh");
    draw_surface(group, view, tree, paint);
    name_axes(group, view);
    add_text(group, view.middle(), view.top + view.height() + px(30), caption, {{"class", "panel middle"}});
    right = std::max(right, view.left + view.width());
    bottom = std::max(bottom, view.top + view.height() + px(50));
    ++number_;
  }

  Px right = 0;
  Px bottom = 0;

 private:
  Picture& picture_;
  PerAxis<int> domain_;
  std::size_t number_ = 0;
};

std::vector<std::string> row_of(const RefinementTree& tree, const Iterations& iterations, std::size_t iteration) {
  std::array<std::int64_t, kIterations> of_level{};
  for (const auto& [element, number] : iterations) {
    if (number <= iteration) ++of_level.at(at(tree.level(element)));
  }
  return {std::to_string(iteration), std::to_string(marked_after(iterations, iteration)), std::to_string(of_level[2]),
          std::to_string(of_level[1]), std::to_string(of_level[0])};
}

}  // namespace

void add_refinement_iterations(const PaperCases& cases, Paper& paper) {
  RefinementTree tree = mesh_after(cases.refinement, cases.refinement.steps.size() - 1);
  const std::int32_t mark = tree.leaf_at(cases.refinement.steps.back().marks.front());
  const Iterations iterations = iterations_of(tree, mark);
  std::vector<std::vector<std::string>> rows{{"after iteration", "marked", "of level 2", "of level 1", "of level 0"}};
  std::string description = "Five meshes seen from below their corner at the origin.";
  Picture picture("Refinement of one element K of level 2, p = (3,3,3), m = 3", "");
  Panels panels(picture, cases.refinement.domain);
  for (std::size_t iteration = 0; iteration <= kIterations; ++iteration) {
    const std::size_t marked = marked_after(iterations, iteration);
    const std::string caption =
        iteration == 0 ? std::string("marked: K") : fmt::format("iteration {}: {} marked", iteration, marked);
    panels.draw(
        tree, [&](std::int32_t leaf) { return colour_of(iterations, leaf, iteration); }, caption);
    rows.push_back(row_of(tree, iterations, iteration));
    description += fmt::format(" After iteration {}: {} elements marked.", iteration, marked);
  }
  const std::int64_t before = tree.element_count();
  const auto subdivided = refine(tree, std::span(&mark, 1));
  ensure(subdivided.size() == iterations.size(), "the iterations end in the closure");
  panels.draw(
      tree, [&](std::int32_t leaf) { return colour_of(iterations, tree.parent(leaf), kIterations); },
      fmt::format("subdivided: {} elements", tree.element_count()));
  description += fmt::format(" All of them subdivided: {} elements, {} before.", tree.element_count(), before);
  picture.svg().child("desc").text() = description.c_str();
  const Px bottom = picture.add_legend(kPictureMargin, panels.bottom,
                                       {{kVermilion, "K, and its children"},
                                        {kOrange, "marked in the first iteration (level 1), and their children"},
                                        {kBlue, "marked in the second iteration (level 0), and their children"},
                                        {kPlain, "not marked"}});
  paper.files.push_back({"figure-refinement.svg", picture.finish(panels.right, bottom)});
  rows.push_back({"subdivided", fmt::format("{} elements become {}", before, tree.element_count()), "", "", ""});
  paper.tables["refinement"] = markdown_table(rows);
}

}  // namespace asts
