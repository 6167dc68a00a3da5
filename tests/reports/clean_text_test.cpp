#include "reports/clean_text.hpp"

#include <gtest/gtest.h>

namespace asts {
namespace {

TEST(CleanText, KeepsWhatIsClean) {
  for (const std::string text : {"", "as\tb\nc\r", "\xC3\xA9", "\xE2\x89\xA4", "\xF0\x9F\x98\x80", "\x7F",
                                 "\xEE\x80\x80", "\xED\x9F\xBF", "\xEF\xBF\xBD", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(clean_text(text), text);
  }
}

TEST(CleanText, ReplacesEachByteThatBelongsToNoCharacter) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text("a\xFFz"), "a" + bad + "z");
  EXPECT_EQ(clean_text("\x80"), bad);
  EXPECT_EQ(clean_text("\xC3"), bad);
  EXPECT_EQ(clean_text("\xC3z"), bad + "z");
  EXPECT_EQ(clean_text("\xE2\x89"), bad + bad);
  EXPECT_EQ(clean_text("\xC0\x80"), bad + bad) << "overlong";
  EXPECT_EQ(clean_text("\xE0\x9F\xBF"), bad + bad + bad) << "overlong";
  EXPECT_EQ(clean_text("\xF8\x88\x80\x80\x80"), bad + bad + bad + bad + bad);
}

TEST(CleanText, ReplacesCharactersThatXmlDoesNotHave) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text(std::string("\0\x01\x1F\x0B", 4)), bad + bad + bad + bad);
  EXPECT_EQ(clean_text("\xED\xA0\x80"), bad) << "a surrogate";
  EXPECT_EQ(clean_text("\xEF\xBF\xBE\xEF\xBF\xBF"), bad + bad);
  EXPECT_EQ(clean_text("\xF4\x90\x80\x80"), bad) << "beyond U+10FFFF";
}

}  // namespace
}  // namespace asts
