#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

const std::filesystem::path kRoot = std::filesystem::weakly_canonical(std::filesystem::path(ASTS_CASES) / ".." / "..");

/// A command of the README with what is printed below it; "..." stands for any lines.
struct Shown {
  Names arguments;
  std::string redirected_to;  ///< the file behind ">", if any
  Names output;
};

Shown command_of(const std::string& line) {
  std::istringstream words(line);
  Shown shown;
  for (std::string word; words >> word;) {
    if (word == "#") break;
    if (word == ">") {
      words >> shown.redirected_to;
    } else {
      shown.arguments.push_back(word);
    }
  }
  return shown;
}

/// The lines `$ asts ...` of fenced blocks, each with the lines below it.
std::vector<Shown> shown_commands() {
  std::vector<Shown> commands;
  bool fenced = false;
  bool below = false;
  for (const std::string& line : lines_of(content_of((kRoot / "README.md").string()))) {
    if (line.starts_with("```")) {
      fenced = !fenced;
      below = false;
    } else if (fenced && line.starts_with("$ ")) {
      below = line.starts_with("$ asts ");
      if (below) commands.push_back(command_of(line.substr(std::string("$ asts ").size())));
    } else if (below) {
      commands.back().output.push_back(line);
    }
  }
  return commands;
}

/// Whether the lines shown are those of the output, "..." being any number of them, and any end of a line.
bool matches(const Names& shown, std::size_t s, const Names& lines, std::size_t l) {
  if (s == shown.size()) return l == lines.size();
  if (shown[s] == "...") {
    return matches(shown, s + 1, lines, l) || (l < lines.size() && matches(shown, s, lines, l + 1));
  }
  if (l == lines.size()) return false;
  const bool cut = shown[s].ends_with("...");
  const std::string text = cut ? shown[s].substr(0, shown[s].size() - 3) : shown[s];
  return (cut ? lines[l].starts_with(text) : lines[l] == text) && matches(shown, s + 1, lines, l + 1);
}

/// The tests/cases of the README are the ones here; files that a command writes go into a folder.
std::string in_folder(const TemporaryFolder& folder, const std::string& argument) {
  return argument.starts_with("/tmp/") ? folder.path(argument.substr(5)) : argument;
}

// Runs the commands one after the other, in the project's folder, and compares what the README shows.
TEST(Readme, ShowsWhatItsCommandsPrint) {
  const TemporaryFolder folder;
  const std::vector<Shown> commands = shown_commands();
  ASSERT_GE(commands.size(), 5U);
  for (const Shown& shown : commands) {
    Names arguments;
    for (const std::string& argument : shown.arguments) arguments.push_back(in_folder(folder, argument));
    const Outcome outcome = run(arguments, {}, kRoot.string());
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
    if (!shown.redirected_to.empty()) {
      std::ofstream(in_folder(folder, shown.redirected_to)) << outcome.out;
      continue;
    }
    const bool only_the_end = shown.output.empty();
    EXPECT_TRUE(only_the_end || matches(shown.output, 0, lines_of(outcome.out), 0))
        << ::testing::PrintToString(shown.arguments) << " prints\n"
        << outcome.out;
  }
}

// The case in the README is one.
TEST(Readme, ShowsACase) {
  const std::string text = content_of((kRoot / "README.md").string());
  const std::string fence = "```\n";
  const std::size_t fenced = text.find(fence + "asts-case 1");
  ASSERT_NE(fenced, std::string::npos);
  const std::size_t begin = fenced + fence.size();
  const Outcome outcome = run({"check", "-"}, text.substr(begin, text.find(fence, begin) - begin));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Readme, NamesEveryCommandAndEveryOption) {
  const std::string text = content_of((kRoot / "README.md").string());
  for (const char* word : {"campaign",
                           "--time",
                           "--resume",
                           "--timeout",
                           "--memory",
                           "--replay",
                           "check",
                           "draw",
                           "asts report DIR -o",
                           "asts export CASE -o",
                           "--node",
                           "--perturbed-regions",
                           "--out",
                           "refine",
                           "generate",
                           "enumerate",
                           "validate",
                           "claims",
                           "ledger",
                           "--claim",
                           "--long",
                           "--seed",
                           "--cases",
                           "--jobs",
                           "--times",
                           "--render",
                           "./build.sh ledger",
                           "--max-subdivisions",
                           "--admissible",
                           "--no-symmetry",
                           "--property",
                           "--final",
                           "--format",
                           "--budget",
                           "--write",
                           "--degree",
                           "--grading",
                           "--domain",
                           "--elements",
                           "./build.sh verify",
                           "./build.sh test"}) {
    EXPECT_NE(text.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace asts::testing
