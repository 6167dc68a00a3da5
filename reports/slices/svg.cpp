#include "reports/slices/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace asts {

namespace {

struct ToString : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

}  // namespace

std::string decimal(Px length) {
  const Px size = length < 0 ? -length : length;
  return fmt::format("{}{}.{:02}", length < 0 ? "-" : "", size / 100, size % 100);
}

Px rounded_px(const Rational& pixels) {
  const Rational shifted = pixels * 100 + Rational(1, 2);
  const Integer top = boost::multiprecision::numerator(shifted);
  const Integer bottom = boost::multiprecision::denominator(shifted);
  Integer quotient = top / bottom;
  if (top < 0 && quotient * bottom != top) quotient -= 1;
  return quotient.convert_to<Px>();
}

XmlNode add_node(XmlNode parent, const char* name, Attributes attributes) {
  XmlNode node = parent.append_child(name);
  for (const auto& [key, value] : attributes) node.append_attribute(key) = value.c_str();
  return node;
}

XmlNode add_group(XmlNode parent, const char* css_class) { return add_node(parent, "g", {{"class", css_class}}); }

XmlNode add_rect(XmlNode parent, const PxBox& box, Attributes attributes) {
  XmlNode node = add_node(parent, "rect", attributes);
  node.append_attribute("x") = decimal(box.lower[0]).c_str();
  node.append_attribute("y") = decimal(box.lower[1]).c_str();
  node.append_attribute("width") = decimal(box.width()).c_str();
  node.append_attribute("height") = decimal(box.height()).c_str();
  return node;
}

XmlNode add_outline(XmlNode parent, const PxBox& box, Attributes attributes) {
  XmlNode node = add_node(parent, "path", attributes);
  node.append_attribute("d") = fmt::format("M{} {}H{}V{}H{}Z", decimal(box.lower[0]), decimal(box.lower[1]),
                                           decimal(box.upper[0]), decimal(box.upper[1]), decimal(box.lower[0]))
                                   .c_str();
  return node;
}

XmlNode add_line(XmlNode parent, Px x1, Px y1, Px x2, Px y2, Attributes attributes) {
  XmlNode node = add_node(parent, "line", attributes);
  node.append_attribute("x1") = decimal(x1).c_str();
  node.append_attribute("y1") = decimal(y1).c_str();
  node.append_attribute("x2") = decimal(x2).c_str();
  node.append_attribute("y2") = decimal(y2).c_str();
  return node;
}

XmlNode add_text(XmlNode parent, Px x, Px y, const std::string& text, Attributes attributes) {
  XmlNode node = add_node(parent, "text", attributes);
  node.append_attribute("x") = decimal(x).c_str();
  node.append_attribute("y") = decimal(y).c_str();
  node.text() = text.c_str();
  return node;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t characters) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > characters) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

std::vector<int> stagger(const std::vector<std::pair<Px, Px>>& centres_and_lengths, int rows) {
  std::vector<std::vector<std::pair<Px, Px>>> taken(static_cast<std::size_t>(rows));
  std::vector<int> result;
  for (const auto& [centre, length] : centres_and_lengths) {
    const auto free = [c = centre, l = length](const auto& row) {
      return std::none_of(row.begin(), row.end(),
                          [&](const auto& other) { return std::abs(other.first - c) * 2 < other.second + l; });
    };
    const auto row = std::find_if(taken.begin(), taken.end(), free);
    result.push_back(row == taken.end() ? -1 : static_cast<int>(row - taken.begin()));
    if (row != taken.end()) row->emplace_back(centre, length);
  }
  return result;
}

std::string xml_text(const pugi::xml_document& document) {
  ToString writer;
  document.save(writer, " ", pugi::format_indent, pugi::encoding_utf8);
  return writer.text;
}

}  // namespace asts
