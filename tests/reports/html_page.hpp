#pragma once

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>
#include <string>

namespace asts::testing {

/// Expects what every page of a report must be: well-formed, self-contained, and with what readers who do not see or do
/// not use a mouse need.
class HtmlPage {
 public:
  explicit HtmlPage(const std::string& text) : text_(text) {
    EXPECT_TRUE(text.starts_with("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">"));
    const auto result = document_.load_string(text.c_str(), pugi::parse_full);
    EXPECT_TRUE(result) << result.description() << " at " << text.substr(static_cast<std::size_t>(result.offset), 80);
    expect_no_fetches();
    expect_ids_are_unique_and_links_lead_somewhere();
    expect_tables_and_pictures_speak();
    expect_headings_in_order();
  }

  const pugi::xml_document& document() const { return document_; }

 private:
  pugi::xpath_node_set all(const char* query) const { return document_.select_nodes(query); }

  void expect_no_fetches() const {
    for (const auto& one : all("//@src | //@href | //@*[local-name()='href'] | //@data | //@poster | //@action")) {
      EXPECT_EQ(one.attribute().value()[0], '#') << one.attribute().value();
    }
    EXPECT_TRUE(
        all("//*[name()='link' or name()='iframe' or name()='object' or name()='embed' or name()='base']").empty());
    EXPECT_EQ(text_.find("@import"), std::string::npos);
    for (std::size_t at = text_.find("url("); at != std::string::npos; at = text_.find("url(", at + 1)) {
      EXPECT_EQ(text_.substr(at, 5), "url(#") << text_.substr(at, 40);
    }
  }

  void expect_ids_are_unique_and_links_lead_somewhere() const {
    std::set<std::string> ids;
    for (const auto& one : all("//@id"))
      EXPECT_TRUE(ids.insert(one.attribute().value()).second) << one.attribute().value();
    for (const auto& one : all("//@href | //@aria-labelledby")) {
      std::string id = one.attribute().value();
      if (id.starts_with("#")) id.erase(0, 1);
      EXPECT_TRUE(ids.contains(id)) << id;
    }
    for (std::size_t at = text_.find("url(#"); at != std::string::npos; at = text_.find("url(#", at + 1)) {
      const std::string id = text_.substr(at + 5, text_.find(')', at) - at - 5);
      EXPECT_TRUE(ids.contains(id)) << id;
    }
  }

  void expect_tables_and_pictures_speak() const {
    for (const auto& one : all("//table")) {
      EXPECT_TRUE(one.node().child("caption")) << "a table without a caption";
      EXPECT_STREQ(one.node().parent().attribute("class").value(), "wide");
      EXPECT_STREQ(one.node().parent().attribute("tabindex").value(), "0");
    }
    EXPECT_TRUE(all("//table//th[not(@scope)]").empty());
    EXPECT_TRUE(all("//tbody/tr[not(th)]").empty());
    EXPECT_TRUE(all("//*[name()='svg'][not(@role='img') or not(@aria-label) or not(*[name()='title']) or "
                    "not(*[name()='desc'])]")
                    .empty());
    EXPECT_TRUE(all("//figure[not(figcaption)]").empty());
  }

  void expect_headings_in_order() const {
    int before = 0;
    for (const auto& one : all("//h1 | //h2 | //h3 | //h4 | //h5 | //h6")) {
      const int level = one.node().name()[1] - '0';
      EXPECT_LE(level, before + 1) << one.node().text().get();
      before = level;
    }
    EXPECT_EQ(all("//h1").size(), 1U);
    EXPECT_EQ(all("//main").size(), 1U);
  }

  std::string text_;
  pugi::xml_document document_;
};

}  // namespace asts::testing
