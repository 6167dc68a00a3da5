#include <gtest/gtest.h>

#include <map>
#include <random>

#include "lib/zones/bits.hpp"
#include "lib/zones/box_tree.hpp"
#include "lib/zones/list_table.hpp"

namespace asts {
namespace {

TEST(ListTable, GivesEqualListsOneIdentifier) {
  ListTable table;
  std::map<std::vector<std::int32_t>, std::int32_t> expected;
  std::mt19937_64 random(5);
  for (int round = 0; round < 5000; ++round) {
    std::vector<std::int32_t> list(random() % 4);
    for (std::int32_t& entry : list) entry = static_cast<std::int32_t>(random() % 7);
    const std::int32_t id = table.intern(list);
    const auto [known, is_new] = expected.try_emplace(list, id);
    EXPECT_EQ(known->second, id);
    EXPECT_EQ(table.size(), static_cast<std::int32_t>(expected.size()));
    const auto stored = table[id];
    EXPECT_EQ(std::vector<std::int32_t>(stored.begin(), stored.end()), list);
  }
  table.clear();
  EXPECT_EQ(table.size(), 0);
}

TEST(BitRows, KeepRowsApart) {
  BitRows rows;
  rows.reset(3, 130);
  rows.set(1, 129);
  rows.set(2, 0);
  EXPECT_TRUE(rows.test(1, 129));
  EXPECT_FALSE(rows.test(1, 0));
  EXPECT_FALSE(rows.any(0));
  rows.unite(0, rows, 1);
  rows.unite(0, rows, 2);
  EXPECT_TRUE(rows.test(0, 129));
  EXPECT_TRUE(rows.test(0, 0));
  EXPECT_FALSE(rows.test(2, 129));
}

/// Boxes between the integer lines of one long axis and two short ones, against asking each.
TEST(BoxTree, FindsEveryBoxThatTouches) {
  const RefinementTree tree({{3, 3, 3}, 2, {40, 6, 6}});
  std::mt19937_64 random(9);
  const auto side = [&](int length) {
    const auto a = static_cast<std::int32_t>(random() % at(length + 1));
    const auto b = static_cast<std::int32_t>(random() % at(length + 1));
    return RankInterval{std::min(a, b), std::max(a, b)};
  };
  const auto box = [&] { return RankBox{{side(40), side(6), side(6)}}; };  // line i has rank i
  std::vector<RankBox> boxes;
  for (int i = 0; i < 37; ++i) boxes.push_back(i % 9 == 4 ? BoxTree::nothing() : box());
  BoxTree index(tree);
  index.assign(boxes);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    if (round % 10 == 9) {
      const std::size_t place = random() % boxes.size();
      boxes[place] = round % 20 == 9 ? box() : BoxTree::nothing();
      index.replace(place, boxes[place]);
    }
    const RankBox wanted = box();
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i][0].lower >= 0 && touch(boxes[i], wanted)) expected.push_back(i);
    }
    std::vector<std::size_t> places;
    index.for_each_touching(wanted, [&](std::size_t place) { places.push_back(place); });
    EXPECT_EQ(places, expected);
    found += static_cast<int>(places.size());
  }
  EXPECT_GT(found, 300);
}

}  // namespace
}  // namespace asts
