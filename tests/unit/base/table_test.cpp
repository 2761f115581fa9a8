#include "base/table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gliftc {
namespace {

struct Item {
    int number = 0;
};

TEST(Table, GivesTheIdsOfItsValues) {
    Table<Item> items;
    const Id<Item> one = items.add({1}), two = items.add({2});
    EXPECT_EQ(items[two].number, 2);
    EXPECT_EQ(items.id_of(items[one]), one);
    std::vector<Id<Item>> ids;
    for (const Id<Item> id : items.ids()) ids.push_back(id);
    EXPECT_EQ(ids, (std::vector{one, two}));
}

TEST(Table, ContainsNeitherEmptyNorLaterIds) {
    Table<Item> items;
    const Id<Item> one = items.add({1});
    EXPECT_TRUE(items.contains(one));
    EXPECT_FALSE(items.contains({one.index + 1}));
    EXPECT_FALSE(items.contains({}));
}

TEST(Table, LiesBesideAnotherTable) {
    Table<Item> items;
    const Id<Item> one = items.add({1});
    Table<std::string, Item> names(items.size());
    names[one] = "one";
    EXPECT_EQ(names.front(), "one");
}

}  // namespace
}  // namespace gliftc
