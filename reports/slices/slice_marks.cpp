#include "reports/slices/slice_marks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asts {

namespace {

constexpr std::size_t kMostSlices = 6;

std::string text(const ExactPoint& point) {
  return fmt::format("({}, {}, {})", to_string(point[0]), to_string(point[1]), to_string(point[2]));
}

/// One value of a claim's witness, where it is a place.
struct AddValue {
  SliceMarks& marks;
  const std::string& name;

  void operator()(const ExactPoint& point) const { marks.points.push_back({name, point}); }
  void operator()(const ExactBox& box) const { marks.boxes.push_back({name, box}); }
  void operator()(const ElementInfo& element) const { marks.boxes.push_back({name, element.box}); }
  void operator()(const ActiveNodeInfo& node) const { marks.nodes.push_back({name, node}); }
  template <class Other>
  void operator()(const Other&) const {}
};

struct MarksOf {
  SliceMarks operator()(const CoarserInPatchWitness& w) const {
    return {"the element E was subdivided, though its environment U meets the coarser element C",
            {},
            {},
            {{"E", w.element.box}, {"C", w.coarser.box}, {"U", w.environment}},
            {}};
  }
  SliceMarks operator()(const OutsideClassWitness& w) const {
    return {"no level-directed subdivisions make the element E", {}, {}, {{"E", w.element.box}}, {}};
  }
  SliceMarks operator()(const PatchNotNestedWitness& w) const {
    return {"K lies in L, and C is in the patch of K, but not in the patch of L",
            {},
            {},
            {{"K", w.inner.box}, {"L", w.outer.box}, {"C", w.element.box}},
            {}};
  }
  SliceMarks operator()(const RegionsMeetWitness& w) const {
    return {fmt::format("the perturbed regions R_{} and R_{} meet at t = {}", axis_name(w.first.axis),
                        axis_name(w.second.axis), text(w.point)),
            {{"v1", w.first.in}, {"v2", w.first.out}, {"v3", w.second.in}, {"v4", w.second.out}},
            {{"t", w.point}},
            {},
            {{"v2", w.first.axis, w.first.slice}, {"v4", w.second.axis, w.second.slice}}};
  }
  SliceMarks operator()(const NoPartialOverlapWitness& w) const {
    SliceMarks marks;
    std::string axes;
    for (const NoOverlapInfo& info : w.axes) {
      axes += std::string(axes.empty() ? "" : " and ") + axis_name(info.axis);
      marks.missing.push_back({info.in_v ? "w" : "v", info.axis, info.coordinate});
    }
    marks.says = "the supports of v and w share volume, but their index vectors do not overlap along " + axes;
    marks.nodes = {{"v", w.v}, {"w", w.w}};
    return marks;
  }
  SliceMarks operator()(const LambdaNotDeltaWitness& w) const {
    return {fmt::format("lambda_v(B_w) is not {}", w.expected), {{"v", w.v}, {"w", w.w}}, {}, {}, {}};
  }
  SliceMarks operator()(const ClaimWitness& w) const {
    SliceMarks marks;
    marks.says = w.says;
    for (const auto& [name, value] : w.values) std::visit(AddValue{marks, name}, value);
    return marks;
  }
};

/// Several names of one node become one.
void join_equal_nodes(SliceMarks& marks) {
  std::vector<SliceMarks::Node> distinct;
  for (const SliceMarks::Node& node : marks.nodes) {
    const auto same = std::find_if(distinct.begin(), distinct.end(),
                                   [&](const SliceMarks::Node& other) { return other.info.node == node.info.node; });
    if (same == distinct.end()) {
      distinct.push_back(node);
      continue;
    }
    const std::string joined = same->name + " = " + node.name;
    for (SliceMarks::Missing& missing : marks.missing) {
      if (missing.node == same->name || missing.node == node.name) missing.node = joined;
    }
    same->name = joined;
  }
  marks.nodes = std::move(distinct);
}

/// Planes in the order in which they are named, each once, inside the domain.
class Planes {
 public:
  explicit Planes(const Setting& setting) : setting_(setting) {}

  void add(Axis axis, const Rational& position) {
    if (position < 0 || position > setting_.domain[at(axis)] || slices_.size() == kMostSlices) return;
    const Slice slice{axis, position};
    if (std::find(slices_.begin(), slices_.end(), slice) == slices_.end()) slices_.push_back(slice);
  }
  void add_through(const ExactPoint& point) {
    for (Axis axis = 0; axis < kDimension; ++axis) add(axis, point[at(axis)]);
  }
  void add_middle(const ExactBox& box) {
    for (Axis axis = 0; axis < kDimension; ++axis) add(axis, (box.lower[at(axis)] + box.upper[at(axis)]) / 2);
  }
  void add_all(const SliceMarks& marks) {
    for (const SliceMarks::Point& mark : marks.points) add_through(mark.point);
    for (const SliceMarks::Node& mark : marks.nodes) add_through(mark.info.node);
    for (const SliceMarks::Box& mark : marks.boxes) add_middle(mark.box);
  }

  /// By axis, then by position.
  std::vector<Slice> sorted() && {
    std::sort(slices_.begin(), slices_.end(), [](const Slice& one, const Slice& other) {
      return one.axis != other.axis ? one.axis < other.axis : one.position < other.position;
    });
    return std::move(slices_);
  }
  bool empty() const { return slices_.empty(); }

 private:
  const Setting& setting_;
  std::vector<Slice> slices_;
};

std::optional<Axis> axis_named(const std::string& name) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (name == axis_name(axis)) return axis;
  }
  return std::nullopt;
}

/// "x = 5/2"
void add_slice_text(Planes& planes, const std::string& text) {
  const std::string equals = " = ";
  const std::size_t place = text.find(equals);
  if (place == std::string::npos) return;
  const auto axis = axis_named(text.substr(0, place));
  const auto number = parse_rational(text.substr(place + equals.size()));
  if (axis && std::holds_alternative<Rational>(number)) planes.add(*axis, std::get<Rational>(number));
}

/// The slices among a claim's values: an "axis" with a "slice" behind it, or a text such as "x = 5/2".
void add_slices(Planes& planes, const ClaimWitness& witness) {
  std::optional<Axis> axis;
  for (const auto& [name, value] : witness.values) {
    if (const auto* word = std::get_if<std::string>(&value)) {
      if (name == "axis") axis = axis_named(*word);
      add_slice_text(planes, *word);
    }
    const auto* position = std::get_if<Rational>(&value);
    if (position != nullptr && axis && name == "slice") planes.add(*axis, *position);
  }
}

}  // namespace

SliceMarks marks_of(const Witness& witness) {
  SliceMarks marks = std::visit(MarksOf{}, witness);
  join_equal_nodes(marks);
  return marks;
}

std::vector<Slice> slices_that_matter(const Witness* witness, const Setting& setting) {
  Planes planes(setting);
  if (witness != nullptr) {
    if (const auto* claim = std::get_if<ClaimWitness>(witness)) add_slices(planes, *claim);
    const auto* meeting = std::get_if<RegionsMeetWitness>(witness);
    if (meeting != nullptr) {
      planes.add_through(meeting->point);
    } else {
      planes.add_all(marks_of(*witness));
    }
  }
  if (planes.empty()) {
    for (Axis axis = 0; axis < kDimension; ++axis) planes.add(axis, Rational(setting.domain[at(axis)], 2));
  }
  return std::move(planes).sorted();
}

}  // namespace asts
