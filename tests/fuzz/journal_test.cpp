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
    const JournalContent content = read_journal(file);
    EXPECT_EQ(content.objects, Objects(kObjects.begin(), kObjects.begin() + static_cast<long>(complete))) << bytes;
    EXPECT_EQ(content.ends.size(), complete);
  }
}

TEST(Journal, GoesOnBehindWhatIsComplete) {
  const TemporaryFolder folder;
  const std::string text = journal_text();
  const std::string file = folder.write("journal", text.substr(0, text.size() - 3));
  {
    Journal journal(file, read_journal(file).ends.back());
    journal.append(kObjects[0]);
  }
  EXPECT_EQ(read_journal(file).objects, (Objects{kObjects[0], kObjects[1], kObjects[0]}));
  Journal(file, read_journal(file).ends[0]).append(kObjects[2]);
  EXPECT_EQ(read_journal(file).objects, (Objects{kObjects[0], kObjects[2]}));
}

TEST(Journal, HasNothingWhereThereIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_journal(folder.path("none")).objects.empty());
}

// That is no cut: to go on would lose what stands behind.
TEST(Journal, RefusesALineThatIsDamagedBeforeAnother) {
  const TemporaryFolder folder;
  std::string text = journal_text();
  text[sealed(kObjects[0]).size() + 5] ^= 1;
  const std::string file = folder.write("journal", text);
  try {
    read_journal(file);
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
