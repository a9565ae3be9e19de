#include "database/format/name_directory.h"
#include "tests/database/format/sample_database.h"

#include <gtest/gtest.h>

namespace linkdig::database {

namespace {

TEST(NameDirectory, FindsTheRowsOfThePacketsTables) {
    const NameDirectory names = name_directory(sample_database(), 0x1234);
    EXPECT_EQ(names.database_name, "sample");
    EXPECT_EQ(names.database_id, 0x1234U);
    EXPECT_EQ(names.find_sun("fixed"), 1U);
    EXPECT_EQ(names.find_moving_object("lph"), 0U);
    EXPECT_EQ(names.find_slot("wake"), 0U);
    EXPECT_EQ(names.slots[0].alternatives, 2U);
    EXPECT_EQ(names.find_colour("deck"), 1U);
    EXPECT_EQ(names.find_cluster("ground"), 2U);
    EXPECT_EQ(names.find_list("wake"), 1U); // a slot's name, too: kinds do not mix
}

TEST(NameDirectory, HasTheListsLight) {
    const NameDirectory names = name_directory(sample_database(), 1);
    ASSERT_EQ(names.lists.size(), 4U);
    EXPECT_EQ(names.lists[0], (NameDirectory::List{"hull", 1, 0.25F, 0.75F}));
    EXPECT_EQ(names.lists[1], (NameDirectory::List{"wake", 0, 0.0F, 1.0F}));
}

TEST(NameDirectory, FindsNothingByAnotherName) {
    const NameDirectory names = name_directory(sample_database(), 1);
    EXPECT_EQ(names.find_sun(""), std::nullopt);
    EXPECT_EQ(names.find_sun("Fixed"), std::nullopt);
    EXPECT_EQ(names.find_sun("lph"), std::nullopt);
    EXPECT_EQ(name_directory({}, 0).find_list("hull"), std::nullopt);
}

} // namespace

} // namespace linkdig::database
