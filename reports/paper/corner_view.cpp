#include "reports/paper/corner_view.hpp"

#include <fmt/format.h>

#include <map>

#include "properties/describe.hpp"

namespace asts {

namespace {

const Rational kAcross(13, 15);
const Rational kRise(1, 2);

/// The sides that are seen are the lighter the more they face up.
constexpr PerAxis<const char*> kShadow{"0.05", "0.12", "0"};

ExactBox domain_box(const CornerView& view) { return {{0, 0, 0}, {view.domain[0], view.domain[1], view.domain[2]}}; }

const Rational& seen_position(const ExactBox& box, Axis axis) {
  return (seen_above(axis) ? box.upper : box.lower)[at(axis)];
}

}  // namespace

std::array<Px, 2> CornerView::place(const ExactPoint& point) const {
  const Rational across = (point[0] - point[1] + domain[1]) * kAcross;
  const Rational up = point[2] + (point[0] + point[1]) * kRise;
  return {left + rounded_px(across * scale), top + height() - rounded_px(up * scale)};
}

Px CornerView::width() const { return rounded_px(kAcross * (domain[0] + domain[1]) * scale); }

Px CornerView::height() const { return rounded_px((domain[2] + kRise * (domain[0] + domain[1])) * scale); }

std::string face_path(const CornerView& view, Axis axis, const Rational& position, const ExactBox& box) {
  const std::size_t b = at(axis_after(axis));
  const std::size_t c = at(axis_after(axis_after(axis)));
  std::string path;
  std::array<Px, 2> last{};
  for (const std::array<bool, 2>& corner : {std::array{false, false}, {true, false}, {true, true}, {false, true}}) {
    ExactPoint point;
    point[at(axis)] = position;
    point[b] = (corner[0] ? box.upper : box.lower)[b];
    point[c] = (corner[1] ? box.upper : box.lower)[c];
    const auto [x, y] = view.place(point);
    path += path.empty() ? fmt::format("M{} {}l", decimal(x), decimal(y))
                         : fmt::format("{} {} ", decimal(x - last[0]), decimal(y - last[1]));
    last = {x, y};
  }
  path.back() = 'z';
  return path;
}

void draw_surface(XmlNode parent, const CornerView& view, const RefinementTree& tree, const Paint& paint) {
  const ExactBox domain = domain_box(view);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Rational& position = seen_position(domain, axis);
    std::map<std::string, std::string> faces;
    for (std::int32_t id = 0; id < tree.node_count(); ++id) {
      if (!tree.is_leaf(id)) continue;
      const ExactBox box = describe_tree_element(tree, id).box;
      if (seen_position(box, axis) == position) faces[paint(id)] += face_path(view, axis, position, box);
    }
    for (const auto& [colour, path] : faces)
      add_node(parent, "path", {{"class", "face"}, {"fill", colour}, {"d", path}});
    add_node(parent, "path",
             {{"class", "shadow"}, {"opacity", kShadow[at(axis)]}, {"d", face_path(view, axis, position, domain)}});
  }
  draw_box_edges(parent, view, domain, "border");
}

void draw_box(XmlNode parent, const CornerView& view, const ExactBox& box, const std::string& colour) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::string path = face_path(view, axis, seen_position(box, axis), box);
    add_node(parent, "path", {{"class", "face"}, {"fill", colour}, {"d", path}});
    add_node(parent, "path", {{"class", "shadow"}, {"opacity", kShadow[at(axis)]}, {"d", path}});
  }
  draw_box_edges(parent, view, box, "element");
}

void draw_box_edges(XmlNode parent, const CornerView& view, const ExactBox& box, const char* css_class) {
  std::string path;
  for (Axis axis = 0; axis < kDimension; ++axis) path += face_path(view, axis, seen_position(box, axis), box);
  add_node(parent, "path", {{"class", css_class}, {"d", path}});
}

void name_axes(XmlNode parent, const CornerView& view) {
  const PerAxis<int>& n = view.domain;
  const auto name = [&](const ExactPoint& point, Px right, Px down, const char* text) {
    const auto [x, y] = view.place(point);
    add_text(parent, x + right, y + down, text, {{"class", "middle"}});
  };
  name({Rational(n[0], 2), 0, 0}, px(10), px(14), "x");
  name({0, Rational(n[1], 2), 0}, px(-10), px(14), "y");
  name({n[0], 0, Rational(n[2], 2)}, px(10), px(4), "z");
}

std::string grey_of(std::int32_t level, std::int32_t highest) {
  constexpr std::int32_t kLightest = 252;
  constexpr std::int32_t kDarkest = 170;
  const std::int32_t grey = highest == 0 ? kLightest : kLightest - (kLightest - kDarkest) * level / highest;
  return fmt::format("#{0:02x}{0:02x}{0:02x}", grey);
}

}  // namespace asts
