#include "reports/html/html.hpp"

#include <fmt/format.h>

#include "lib/exact/rational.hpp"
#include "reports/clean_text.hpp"
#include "reports/html/mesh_view.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

/// Elements without an end tag stand here alone.
constexpr const char* kBegin =
    "<!DOCTYPE html>\n"
    "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n"
    "<head>\n"
    "<meta charset=\"utf-8\" />\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n"
    "<meta name=\"color-scheme\" content=\"light dark\" />";

struct ToString : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

/// Lines in the source, which mean nothing, so that people can read it.
void break_line(HtmlNode parent) { parent.append_child(pugi::node_pcdata).set_value("\n"); }

std::string printed(const pugi::xml_node& node) {
  ToString writer;
  node.print(writer, "", pugi::format_raw | pugi::format_no_empty_element_tags, pugi::encoding_utf8);
  return writer.text;
}

/// Styles and scripts are no text for HTML and text for XML: a comment hides the marks from the one that needs none.
void add_verbatim(HtmlNode parent, const char* name, const std::string& content) {
  HtmlNode node = add_html(parent, name);
  add_words(node, "/*");
  node.append_child(pugi::node_cdata).set_value(("*/\n" + content + "/*").c_str());
  add_words(node, "*/");
}

void add_cell(HtmlNode row, const HtmlCell& cell, bool header) {
  HtmlNode node = header ? add_html(row, "th", {{"scope", "row"}}) : add_html(row, "td");
  if (cell.number) node.append_attribute("class") = cell.bar < 0 ? "number" : "number barred";
  if (cell.link.empty()) {
    add_words(node, cell.text);
  } else {
    add_html(node, "a", {{"href", "#" + cell.link}}, cell.text);
  }
  if (cell.bar < 0) return;
  add_html(node, "span",
           {{"class", "bar"},
            {"aria-hidden", "true"},
            {"style", fmt::format("width:{}.{}%", cell.bar / 10, cell.bar % 10)}});
}

}  // namespace

HtmlNode add_html(HtmlNode parent, const char* name, HtmlAttributes attributes) {
  const std::string_view element = name;
  if (element != "span" && element != "code" && element != "a" && element != "strong") break_line(parent);
  HtmlNode node = parent.append_child(name);
  for (const auto& [key, value] : attributes) node.append_attribute(key) = clean_text(value).c_str();
  return node;
}

HtmlNode add_html(HtmlNode parent, const char* name, HtmlAttributes attributes, const std::string& text) {
  HtmlNode node = add_html(parent, name, attributes);
  add_words(node, text);
  return node;
}

void add_words(HtmlNode parent, const std::string& text) {
  parent.append_child(pugi::node_pcdata).set_value(clean_text(text).c_str());
}

HtmlNode add_paragraph(HtmlNode parent, const std::string& text) { return add_html(parent, "p", {}, text); }

HtmlNode add_section(HtmlNode parent, int level, const std::string& id, const std::string& heading) {
  HtmlNode section = add_html(parent, "section", {{"id", id}, {"aria-labelledby", id + "-heading"}});
  add_html(section, fmt::format("h{}", level).c_str(), {{"id", id + "-heading"}}, heading);
  return section;
}

void add_command(HtmlNode parent, const std::string& command) {
  add_html(add_html(parent, "pre", {{"class", "command"}}), "code", {}, command);
}

void add_lines(HtmlNode parent, const std::string& text) { add_html(parent, "pre", {}, text); }

HtmlNode add_details(HtmlNode parent, const std::string& summary) {
  HtmlNode details = add_html(parent, "details");
  add_html(details, "summary", {}, summary);
  return details;
}

HtmlCell text_cell(std::string text, std::string link) { return {std::move(text), false, std::move(link), -1}; }

HtmlCell number_cell(long long number) { return {std::to_string(number), true, {}, -1}; }

void add_table(HtmlNode parent, const HtmlTable& table) {
  HtmlNode box = add_html(parent, "div",
                          {{"class", "wide"}, {"role", "region"}, {"aria-labelledby", table.id}, {"tabindex", "0"}});
  HtmlNode node = add_html(box, "table");
  add_html(node, "caption", {{"id", table.id}}, table.caption);
  HtmlNode head = add_html(add_html(node, "thead"), "tr");
  for (const std::string& column : table.columns) add_html(head, "th", {{"scope", "col"}}, column);
  HtmlNode body = add_html(node, "tbody");
  for (const auto& row : table.rows) {
    HtmlNode line = add_html(body, "tr");
    for (std::size_t i = 0; i < row.size(); ++i) add_cell(line, row[i], i == 0);
  }
}

void add_facts(HtmlNode parent, const std::vector<std::pair<std::string, std::string>>& facts) {
  HtmlNode list = add_html(parent, "dl");
  for (const auto& [name, value] : facts) {
    HtmlNode pair = add_html(list, "div");
    add_html(pair, "dt", {}, name);
    add_html(pair, "dd", {}, value);
  }
}

std::string counted(long long number, const std::string& one, const std::string& many) {
  if (number == 1) return "1 " + one;
  return fmt::format("{} {}", number, many.empty() ? one + "s" : many);
}

std::string percent(long long part, long long whole) {
  if (whole <= 0) return "-";
  const auto thousandths = Integer(Integer(part) * 1000 / whole).convert_to<long long>();
  return fmt::format("{}.{} %", thousandths / 10, thousandths % 10);
}

std::string page_text(const std::string& title, const pugi::xml_document& body) {
  pugi::xml_document head;
  add_html(head, "title", {}, title);
  add_verbatim(head, "style", page_style() + slice_styles() + std::string(mesh_view_style()));
  pugi::xml_document page;
  HtmlNode node = page.append_child("body");
  for (const HtmlNode child : body.children()) node.append_copy(child);
  add_verbatim(node, "script", std::string(mesh_view_script()));
  return std::string(kBegin) + printed(head) + "\n</head>\n" + printed(page) + "\n</html>\n";
}

std::string script_json(std::string_view json) {
  std::string result;
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&') {
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace asts
