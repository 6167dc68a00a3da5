#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asts {

/// The parts of a page, as XML nodes: what is written is well-formed XML and HTML at once (polyglot HTML5), whatever
/// the texts hold, since every text is escaped and characters that XML does not have are replaced (clean_text.hpp).
/// Elements that HTML writes without an end tag (br, img, input, ...) must not be added.

using HtmlNode = pugi::xml_node;
using HtmlAttributes = std::initializer_list<std::pair<const char*, std::string>>;

/// An element at the end of its parent. The second form has a text in it.
HtmlNode add_html(HtmlNode parent, const char* name, HtmlAttributes attributes = {});
HtmlNode add_html(HtmlNode parent, const char* name, HtmlAttributes attributes, const std::string& text);
/// A text behind what the parent has.
void add_words(HtmlNode parent, const std::string& text);
/// A `p`.
HtmlNode add_paragraph(HtmlNode parent, const std::string& text);
/// A `section` that its heading names. `level` is that of the heading, 2 to 6.
HtmlNode add_section(HtmlNode parent, int level, const std::string& id, const std::string& heading);
/// A command that a reader may copy.
void add_command(HtmlNode parent, const std::string& command);
/// Text with its own line ends.
void add_lines(HtmlNode parent, const std::string& text);
/// What is closed at first: `details` with its `summary`.
HtmlNode add_details(HtmlNode parent, const std::string& summary);

/// A cell of a table. `link`: the id of an element of the page, or empty.
struct HtmlCell {
  std::string text;
  bool number = false;
  std::string link = {};
  /// Drawn behind a number: its part of the largest one, in thousandths; below 0: no bar.
  int bar = -1;
};

HtmlCell text_cell(std::string text, std::string link = {});
HtmlCell number_cell(long long number);

/// A table in a box of its own, which scrolls where the page is narrower. The first cell of a row is its header.
struct HtmlTable {
  std::string id;  ///< of the caption
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<HtmlCell>> rows;
};
void add_table(HtmlNode parent, const HtmlTable& table);

/// Names with their values: `dl`.
void add_facts(HtmlNode parent, const std::vector<std::pair<std::string, std::string>>& facts);

/// "1 case", "2 cases"; `many` where an s does not make the plural: "2 meshes".
std::string counted(long long number, const std::string& one, const std::string& many = {});

/// A part of a whole: "27.2 %", rounded down to a tenth; "-" of nothing.
std::string percent(long long part, long long whole);

/// A whole page: `body` is copied into it. No file or network is needed to show it: styles and scripts are inside.
std::string page_text(const std::string& title, const pugi::xml_document& body);

/// The text of reports/html/page.css when the program was built.
std::string page_style();

/// JSON that may stand inside a `script` of both HTML and XML.
std::string script_json(std::string_view json);

}  // namespace asts
