#include "fuzz/campaign/journal.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/exact/errors.hpp"
#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Objects = std::vector<std::string>;

const Objects kObjects{R"({"a":1})", R"({"b":"two, with \"check\":\""})", R"({"c":[3,33]})"};

/// A journal of the three, and its bytes.
std::string journal_text() {
  std::string text;
  for (const std::string& object : kObjects) text += sealed(object) + "\n";
  return text;
}

Objects read(const std::string& file) {
  JournalReader reader(file);
  Objects objects;
  while (auto object = reader.next()) objects.push_back(std::move(*object));
  return objects;
}

/// Behind so many lines.
std::uint64_t end_of(const std::string& file, std::size_t lines) {
  JournalReader reader(file);
  while (reader.line() < lines && reader.next()) {
  }
  return reader.end();
}

TEST(Journal, SealsAnObjectWithAHashOfWhatStandsBefore) {
  EXPECT_EQ(sealed(R"({"a":1})"), R"({"a":1,"check":"c0cb48a96902d276"})");
  EXPECT_EQ(unsealed(sealed(kObjects[1])), kObjects[1]);
}

TEST(Journal, TakesNoChangedLine) {
  const std::string line = sealed(kObjects[0]);
  for (std::size_t place = 0; place < line.size(); ++place) {
    std::string changed = line;
    changed[place] = changed[place] == '7' ? '8' : '7';
    EXPECT_EQ(unsealed(changed), std::nullopt) << changed;
  }
}

// "Cut at any byte": what is complete is read, and nothing else.
TEST(Journal, ReadsWhatIsCompleteWhereverItIsCut) {
  const std::string text = journal_text();
  const TemporaryFolder folder;
  for (std::size_t bytes = 0; bytes <= text.size(); ++bytes) {
    const std::string file = folder.write("journal", text.substr(0, bytes));
    const auto complete =
        static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(bytes), '\n'));
    EXPECT_EQ(read(file), Objects(kObjects.begin(), kObjects.begin() + static_cast<long>(complete))) << bytes;
  }
}

TEST(Journal, GoesOnBehindWhatIsComplete) {
  const TemporaryFolder folder;
  const std::string text = journal_text();
  const std::string file = folder.write("journal", text.substr(0, text.size() - 3));
  {
    Journal journal(file, end_of(file, 3));
    journal.append(kObjects[0]);
  }
  EXPECT_EQ(read(file), (Objects{kObjects[0], kObjects[1], kObjects[0]}));
  Journal(file, end_of(file, 1)).append(kObjects[2]);
  EXPECT_EQ(read(file), (Objects{kObjects[0], kObjects[2]}));
}

TEST(Journal, HasNothingWhereThereIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read(folder.path("none")).empty());
}

// That is no cut: to go on would lose what stands behind.
TEST(Journal, RefusesALineThatIsDamagedBeforeAnother) {
  const TemporaryFolder folder;
  std::string text = journal_text();
  text[sealed(kObjects[0]).size() + 5] ^= 1;
  const std::string file = folder.write("journal", text);
  try {
    read(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file + ":2: the record is damaged");
  }
}

TEST(Journal, LocksAFolderForOneProgram) {
  const TemporaryFolder folder;
  const FolderLock lock(folder.path(""));
  const pid_t child = fork();
  if (child == 0) {
    try {
      const FolderLock second(folder.path(""));
      _exit(0);
    } catch (const InputError&) {
      _exit(7);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Journal, ReplacesAFileAsAWhole) {
  const TemporaryFolder folder;
  replace_file(folder.path("file"), "old");
  replace_file(folder.path("file"), "new");
  EXPECT_EQ(content_of(folder.path("file")), "new");
  EXPECT_FALSE(std::filesystem::exists(folder.path("file.part")));
  EXPECT_THROW(replace_file(folder.path("none/file"), "x"), ResourceError);
}

}  // namespace
}  // namespace asts::testing
