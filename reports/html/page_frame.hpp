#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/html/html.hpp"

namespace asts {

/// A page with its heading, a list of its sections, and a `main` to put them in.
class PageFrame {
 public:
  /// `sections`: ids and headings.
  PageFrame(const std::string& title, const std::string& lead,
            const std::vector<std::pair<std::string, std::string>>& sections);
  PageFrame(const PageFrame&) = delete;
  PageFrame& operator=(const PageFrame&) = delete;

  HtmlNode main() const { return main_; }
  std::string text() &&;

 private:
  std::string title_;
  pugi::xml_document body_;
  HtmlNode main_;
};

}  // namespace asts
