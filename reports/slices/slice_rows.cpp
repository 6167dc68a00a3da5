#include "reports/slices/slice_rows.hpp"

#include <algorithm>
#include <set>

#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

constexpr int kLabelRows = 3;
constexpr Px kLineHeight = px(12);
/// The room for a row's line and its ticks.
constexpr Px kTickRoom = px(16);

Px longest_label(const TickRow& row) {
  std::size_t longest = 1;
  for (const TickRow::Tick& tick : row.ticks) longest = std::max(longest, tick.label.size());
  return text_width(longest) + px(4);
}

/// Integers first: where there is no room for all, these are read.
void place_labels(TickRow& row, std::size_t k, const Rational& scale) {
  std::vector<TickRow::Tick*> order;
  for (TickRow::Tick& tick : row.ticks) {
    tick.label = to_string(tick.at);
    order.push_back(&tick);
  }
  std::stable_partition(order.begin(), order.end(),
                        [](const TickRow::Tick* tick) { return boost::multiprecision::denominator(tick->at) == 1; });
  std::vector<std::pair<Px, Px>> places;
  for (const TickRow::Tick* tick : order) {
    const Px length = k == 0 ? text_width(tick->label.size()) + px(4) : kLineHeight;
    places.emplace_back(rounded_px(tick->at * scale), length);
  }
  const std::vector<int> label_rows = stagger(places, kLabelRows);
  int used = 1;
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i]->label_row = label_rows[i];
    used = std::max(used, label_rows[i] + 1);
  }
  row.thickness = kTickRoom + used * (k == 0 ? kLineHeight : longest_label(row));
  if (k == 1) row.thickness = std::max(row.thickness, text_width(row.name.size()) + px(8));
}

TickRow axis_row(const SliceGeometry& geometry, std::size_t k) {
  std::set<Rational> ends;
  for (const ElementTrace& element : geometry.elements) {
    ends.insert(element.trace.lower[k]);
    ends.insert(element.trace.upper[k]);
  }
  TickRow row{axis_name(axes_in(geometry.slice)[k]), std::nullopt, {}};
  for (const Rational& end : ends) row.ticks.push_back({end});
  return row;
}

TickRow node_row(const SliceMarks& marks, std::size_t node, Axis axis) {
  TickRow row{marks.nodes[node].name, node, {}};
  for (const Rational& entry : marks.nodes[node].info.index_vectors[at(axis)]) row.ticks.push_back({entry});
  for (const SliceMarks::Missing& missing : marks.missing) {
    if (missing.node == row.name && missing.axis == axis) row.ticks.push_back({missing.coordinate, true});
  }
  std::sort(row.ticks.begin(), row.ticks.end(),
            [](const TickRow::Tick& one, const TickRow::Tick& other) { return one.at < other.at; });
  return row;
}

/// Draws a row in coordinates along it and away from the plot, the same for both axes.
class RowDrawing {
 public:
  RowDrawing(XmlNode svg, const Frame& frame, std::size_t k, const TickRow& row, Px distance)
      : frame_(frame), k_(k), row_(row), distance_(distance) {
    group_ = add_node(svg, "g", {{"class", row.node ? "row" : "axis"}});
    if (row.node) group_.append_attribute("stroke") = node_colour(*row.node);
  }

  void draw() {
    if (row_.node) line(along(row_.ticks.front().at), kMiddle, along(row_.ticks.back().at), kMiddle);
    for (const TickRow::Tick& tick : row_.ticks) draw_tick(tick);
    draw_name();
  }

 private:
  static constexpr Px kMiddle = px(8);

  Px along(const Rational& value) const { return k_ == 0 ? frame_.x(value) : frame_.y(value); }
  std::array<Px, 2> place(Px along, Px away) const {
    if (k_ == 0) return {along, frame_.plot.upper[1] + distance_ + away};
    return {frame_.plot.lower[0] - distance_ - away, along};
  }
  void line(Px along1, Px away1, Px along2, Px away2) {
    const auto from = place(along1, away1);
    const auto to = place(along2, away2);
    add_line(group_, from[0], from[1], to[0], to[1]);
  }

  void draw_tick(const TickRow::Tick& tick) {
    if (tick.missing) {
      const auto middle = place(along(tick.at), kMiddle);
      add_cross(group_, middle[0], middle[1]);
    } else {
      line(along(tick.at), row_.node ? px(4) : 0, along(tick.at), row_.node ? px(12) : px(6));
    }
    if (tick.label_row < 0) return;
    const Px step = k_ == 0 ? kLineHeight : longest_label(row_);
    const Px away = px(14) + tick.label_row * step;
    const auto corner = place(along(tick.at), away);
    add_text(group_, corner[0], corner[1] + (k_ == 0 ? px(9) : px(4)), tick.label,
             {{"class", k_ == 0 ? "middle" : "end"}, {"stroke", "none"}});
  }

  /// At the end of the axis; a node's before its first entry.
  void draw_name() {
    if (k_ == 0) {
      const Px right = row_.node ? along(row_.ticks.front().at) - px(8) : frame_.plot.upper[0] + px(10);
      add_text(group_, right, place(0, kMiddle)[1] + px(4), row_.name,
               {{"class", row_.node ? "end" : ""}, {"stroke", "none"}});
    } else {
      const Px down = row_.node ? along(row_.ticks.back().at) - px(8) : frame_.plot.lower[1] - px(10);
      add_text(group_, place(0, kMiddle)[0], down, row_.name, {{"class", "middle"}, {"stroke", "none"}});
    }
  }

  const Frame& frame_;
  std::size_t k_;
  const TickRow& row_;
  Px distance_;
  XmlNode group_;
};

}  // namespace

std::vector<TickRow> rows_along(const SliceGeometry& geometry, const SliceMarks& marks, std::size_t k,
                                const Rational& scale) {
  std::vector<TickRow> rows{axis_row(geometry, k)};
  for (std::size_t node = 0; node < marks.nodes.size(); ++node) {
    rows.push_back(node_row(marks, node, axes_in(geometry.slice)[k]));
  }
  for (TickRow& row : rows) place_labels(row, k, scale);
  return rows;
}

Px total_thickness(const std::vector<TickRow>& rows) {
  Px result = 0;
  for (const TickRow& row : rows) result += row.thickness;
  return result;
}

void draw_rows(XmlNode svg, const Frame& frame, std::size_t k, const std::vector<TickRow>& rows) {
  Px distance = px(3);
  for (const TickRow& row : rows) {
    RowDrawing(svg, frame, k, row, distance).draw();
    distance += row.thickness;
  }
}

}  // namespace asts
