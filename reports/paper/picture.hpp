#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/slices/svg.hpp"

namespace asts {

constexpr Px kPictureMargin = px(20);

/// Colours of Okabe and Ito, mixed with white for areas that carry lines and numbers.
inline constexpr const char* kPlain = "#f7f7f7";
inline constexpr const char* kOrange = "#e69f00";
inline constexpr const char* kVermilion = "#e8743b";
inline constexpr const char* kBlue = "#8cc8ee";
inline constexpr const char* kGreen = "#7fc9b0";

/// An SVG picture on white ground, whatever is around it, with a title, a description in words and numbers, and a
/// heading that shows the title.
class Picture {
 public:
  Picture(const std::string& title, const std::string& description);

  XmlNode svg() { return svg_; }
  /// Where the picture proper begins.
  static constexpr Px top() { return px(52); }
  /// Rows of a sign's colour and what it means, downwards. Returns where they end.
  Px add_legend(Px x, Px y, const std::vector<std::pair<std::string, std::string>>& rows);
  /// The picture's text; its size is the rightmost and lowest place used, and a margin.
  std::string finish(Px right, Px bottom);

 private:
  pugi::xml_document document_;
  XmlNode svg_;
};

}  // namespace asts
