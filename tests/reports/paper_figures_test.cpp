#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <set>
#include <sstream>

namespace asts::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::weakly_canonical(fs::path(ASTS_CASES) / ".." / ".." / "reports" / "paper");

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// What the command writes: the page, the pictures and the data.
std::set<std::string> results_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path path = entry.path();
    const bool result = path.extension() == ".svg" || path.extension() == ".dat" || path.filename() == "README.md";
    if (result) names.insert(path.filename().string());
  }
  return names;
}

/// The version that a plot says it is drawn by; other versions may draw it otherwise. Nothing for other files.
std::string drawn_by(const std::string& content) {
  const std::string begin = "Drawn by gnuplot ";
  const std::size_t place = content.find(begin);
  if (place == std::string::npos) return {};
  return content.substr(place + begin.size(), content.find("</desc>", place) - place - begin.size());
}

pugi::xml_document picture(const std::string& name) {
  pugi::xml_document document;
  const auto result = document.load_file((kFolder / name).c_str());
  EXPECT_TRUE(result) << name << ": " << result.description();
  return document;
}

bool is_picture(const std::string& name) { return name.ends_with(".svg"); }

// The command on the page, with a program that is built already, into another folder.
TEST(PaperFigures, AFreshRunGivesWhatIsCheckedInByteForByte) {
  const fs::path out = fs::path(::testing::TempDir()) / ("asts-paper-figures-" + std::to_string(getpid()));
  fs::remove_all(out);
  const std::string command =
      "'" + (kFolder / "run.sh").string() + "' --program '" ASTS_PAPER_FIGURES "' --out '" + out.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(results_in(out), results_in(kFolder));
  for (const std::string& name : results_in(out)) {
    const std::string fresh = content_of(out / name);
    const std::string checked_in = content_of(kFolder / name);
    if (drawn_by(fresh) != drawn_by(checked_in)) continue;
    EXPECT_TRUE(fresh == checked_in) << name << " is not what `reports/paper/run.sh` writes";
  }
  fs::remove_all(out);
}

TEST(PaperFigures, EveryPictureSaysInWordsWhatIsSeenAndHasAWhiteGround) {
  std::size_t pictures = 0;
  for (const std::string& name : results_in(kFolder)) {
    if (!is_picture(name)) continue;
    ++pictures;
    const pugi::xml_document document = picture(name);
    const pugi::xml_node svg = document.child("svg");
    EXPECT_FALSE(std::string(svg.child("title").text().get()).empty()) << name;
    EXPECT_GT(std::string(svg.child("desc").text().get()).size(), 100U) << name;
    const bool white = !svg.select_nodes(".//rect[@fill='#ffffff']").empty();
    EXPECT_TRUE(white) << name;
  }
  EXPECT_EQ(pictures, 12U);
}

TEST(PaperFigures, ThePageShowsEachPictureAndDataFileAndTheCommand) {
  const std::string page = content_of(kFolder / "README.md");
  for (const std::string& name : results_in(kFolder)) {
    if (name == "README.md") continue;
    const std::string link = "](" + name + ")";
    EXPECT_NE(page.find(link), std::string::npos) << name;
  }
  EXPECT_NE(page.find("    reports/paper/run.sh\n"), std::string::npos);
}

// By hand: the printed table of Example 2.10; for K = [0,1/3] x [0,1/3] x [0,1] and p = 3 the reach is 9/2 lengths; the
// counts by brute force in tests/cases/paper/refinement-figure.case; the values of findings/figure-proof-levels.md and
// findings/experiment-constant.md.
TEST(PaperFigures, ThePageHasThePapersNumbersBesideThoseOfTheProgram) {
  const std::string page = content_of(kFolder / "README.md");
  for (const char* row : {
           "| 2 | 12 | 12 | 10728 | 10728 |",
           "| 4 | 6 | 6 | 3175 | 3175 |",
           "| 16 | 3 | 3 | 1030 | 1030 |",
           "| 2 | [0,1/3] x [0,1/3] x [0,1] | (3/2, 3/2, 9/2) | [0,5/3] x [0,5/3] x [0,5] |",
           "| 0 | 1 | 1 | 0 | 0 |",
           "| 1 | 50 | 1 | 49 | 0 |",
           "| 2 | 162 | 1 | 49 | 112 |",
           "| 3 | 162 | 1 | 49 | 112 |",
           "| patch of K | [6,21/2] x [19/2,12] | [6,21/2] x [8,13] | [6,21/2] x [17/2,13] |",
           "| Sigma | [7,19/2] x [19/2,12] | [7,19/2] x [19/2,12] |",
           "| at step 117 |",
       }) {
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace asts::testing
