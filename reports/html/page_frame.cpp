#include "reports/html/page_frame.hpp"

namespace asts {

PageFrame::PageFrame(const std::string& title, const std::string& lead,
                     const std::vector<std::pair<std::string, std::string>>& sections)
    : title_(title) {
  add_html(body_, "a", {{"class", "skip"}, {"href", "#main"}}, "To the content");
  HtmlNode header = add_html(body_, "header");
  add_html(header, "h1", {}, title);
  add_html(header, "p", {{"class", "lead"}}, lead);
  HtmlNode list = add_html(add_html(body_, "nav", {{"aria-label", "Sections"}}), "ul");
  for (const auto& [id, heading] : sections) {
    add_html(add_html(list, "li"), "a", {{"href", "#" + id}}, heading);
  }
  main_ = add_html(body_, "main", {{"id", "main"}, {"tabindex", "-1"}});
}

std::string PageFrame::text() && { return page_text(title_, body_); }

}  // namespace asts
