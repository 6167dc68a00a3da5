#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "fuzz/targets/corpus.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"

namespace asts::fuzz {
namespace {

const std::string kRoot = std::string(ASTS_CASES) + "/../..";

std::string corpus_of(const Target& target) { return kRoot + "/fuzz/corpora/" + target.name; }

Bytes bytes_of(const std::string& text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

class Corpus : public testing::TestWithParam<const char*> {};

// What fuzzers found, and what they begin with, shows no fault in the ordinary build either.
TEST_P(Corpus, ShowsNoFault) {
  const Target& target = *find_target(GetParam());
  const std::vector<CorpusFile> corpus = read_corpus({corpus_of(target)});
  EXPECT_GE(corpus.size(), 10U);
  for (const CorpusFile& file : corpus) {
    const Fault fault = checked_fault(target, file.bytes);
    EXPECT_FALSE(fault.has_value()) << file.path << ": " << *fault;
    EXPECT_EQ(std::filesystem::path(file.path).filename(), corpus_name(file.bytes));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::Values("claims", "differential", "case_reader", "witness_reader"),
                         [](const auto& target) { return std::string(target.param); });

// The stored findings are what a fuzz run begins with: each that has bytes is in the corpus.
TEST(Corpora, HoldTheStoredFindings) {
  std::set<std::string> names;
  for (const CorpusFile& file : read_corpus({kRoot + "/fuzz/corpora/claims"})) {
    names.insert(std::filesystem::path(file.path).filename());
  }
  int with_bytes = 0;
  for (const char* folder : {"/reports/collection", "/reports/findings"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kRoot + folder)) {
      if (entry.path().extension() != ".case") continue;
      const auto bytes = bytes_of_case(read_case_file(entry.path()));
      if (!bytes) continue;
      ++with_bytes;
      EXPECT_TRUE(names.contains(corpus_name(*bytes))) << entry.path();
    }
  }
  EXPECT_GE(with_bytes, 12);
}

// The corpus of the differential target reaches every verdict that there is to compare.
TEST(Corpora, DecideEveryPropertyBothWays) {
  std::set<std::string> seen;
  for (const CorpusFile& file : read_corpus({kRoot + "/fuzz/corpora/differential"})) {
    const Case content = case_of_bytes(file.bytes, kTinyCases);
    for (const Property& property : all_properties()) {
      const Outcome outcome = try_on_case({nullptr, &property}, content).verdict.outcome;
      seen.insert(std::string(property.id) + " " + outcome_name(outcome));
    }
  }
  for (const Property& property : all_properties()) {
    EXPECT_TRUE(seen.contains(std::string(property.id) + " holds")) << property.id;
    if (std::string_view(property.id) == "nested-patches") continue;  // a lemma that stands
    EXPECT_TRUE(seen.contains(std::string(property.id) + " violated")) << property.id;
  }
}

TEST(ReadCorpus, RefusesAFolderWithoutFiles) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "asts-empty-corpus";
  std::filesystem::create_directories(folder);
  EXPECT_THROW(read_corpus({folder.string()}), InputError);
  EXPECT_THROW(read_corpus({(folder / "missing").string()}), InputError);
}

TEST(CorpusName, IsTheHashOfTheBytes) {
  EXPECT_EQ(corpus_name({}), "cbf29ce484222325");
  EXPECT_EQ(corpus_name(bytes_of("a")), "af63dc4c8601ec8c");
}

TEST(Targets, AreFourAndFoundByName) {
  ASSERT_EQ(all_targets().size(), 4U);
  for (const Target& target : all_targets()) EXPECT_EQ(find_target(target.name), &target);
  EXPECT_EQ(find_target("none"), nullptr);
}

// A target that can never show a fault is none.
TEST(Targets, AnExceptionThatIsNotDocumentedIsAFault) {
  const Target throwing{"throwing", [](Bytes) -> Fault { throw std::out_of_range("beyond"); }, nullptr};
  EXPECT_EQ(checked_fault(throwing, {}), "an exception that is not documented: beyond");
}

}  // namespace
}  // namespace asts::fuzz
