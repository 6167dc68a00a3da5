// Prints a page with a mesh view for each pair of arguments: a case file, and a statement (a property or a claim) that
// is decided for it, or "-". For the tests of the view in a browser.
#include <cstdio>
#include <optional>
#include <string>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/statement.hpp"
#include "reports/html/mesh_view.hpp"
#include "reports/slice_svg.hpp"

namespace asts {
namespace {

std::string static_picture(MeshUnderTest& mesh, const Witness* witness) {
  if (mesh.mesh().elements.size() > kMostElementsWithRegions) return "<svg width=\"10\" height=\"10\"></svg>";
  const std::string svg = slice_pictures(mesh, witness).front().svg;
  return svg.substr(svg.find("<svg"));
}

std::string figure(const std::string& file, const std::string& statement, int number) {
  const Case test_case = read_case_file(file);
  std::optional<Verdict> verdict;
  if (statement != "-") verdict = try_on_case(find_statement(statement).value(), test_case).verdict;
  const Witness* witness = verdict && verdict->witness ? &*verdict->witness : nullptr;
  MeshUnderTest mesh(last_mesh(test_case));
  return "<figure class=\"mesh-view\" id=\"view-" + std::to_string(number) + "\">" + static_picture(mesh, witness) +
         "<figcaption>The last mesh</figcaption><script type=\"application/json\" class=\"mesh-data\">" +
         mesh_view_json(mesh, witness) + "</script></figure>\n";
}

std::string page(int count, char** words) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>Mesh views</title>"
      "<style>body{margin:8px}figure{margin:0}\n" +
      std::string(mesh_view_style()) + "</style></head>\n<body><h1>Mesh views</h1>\n";
  for (int i = 0; i + 1 < count; i += 2) text += figure(words[i], words[i + 1], i / 2 + 1);
  return text + "<script>" + std::string(mesh_view_script()) + "</script></body></html>\n";
}

}  // namespace
}  // namespace asts

int main(int count, char** words) { std::fputs(asts::page(count - 1, words + 1).c_str(), stdout); }
