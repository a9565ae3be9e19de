#include "tools/fly/keys.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace linkdig::tools {
namespace {

TEST(Keys, NoKeyDoesTwoThings) {
    std::set<std::int32_t> codes;
    for (const Key& key : keys()) {
        EXPECT_TRUE(codes.insert(key.code).second) << key.label;
        EXPECT_TRUE(key.other_code == 0 || codes.insert(key.other_code).second) << key.label;
    }
}

TEST(Keys, EveryActionHasAKey) {
    for (int action = 0; action <= static_cast<int>(Action::quit); ++action)
        EXPECT_EQ(std::ranges::count(keys(), static_cast<Action>(action), &Key::action), 1) << action;
}

// SDL's code of a printable key is its character.
TEST(Keys, KeysDoWhatTheirLabelsSay) {
    EXPECT_EQ(action_of(' '), Action::pause);
    EXPECT_EQ(action_of('.'), Action::step);
    EXPECT_EQ(action_of('s'), Action::smooth_shading);
    EXPECT_EQ(action_of('3'), Action::view_right);
    EXPECT_EQ(action_of('r'), Action::view_right);
    EXPECT_EQ(action_of(8), Action::reset);
    EXPECT_EQ(action_of(27), Action::quit);
}

TEST(Keys, AJoysticksButtonsAndHatDoTheSameAsKeys) {
    EXPECT_EQ(action_of_button(0), Action::hands_on);
    EXPECT_EQ(action_of_button(1), Action::pause);
    EXPECT_EQ(action_of_button(2), Action::reset);
    EXPECT_EQ(action_of_button(3), Action::record);
    EXPECT_EQ(action_of_button(4), std::nullopt);
    EXPECT_EQ(action_of_hat(0x01), Action::view_ahead); // SDL_HAT_UP, and clockwise
    EXPECT_EQ(action_of_hat(0x02), Action::view_right);
    EXPECT_EQ(action_of_hat(0x04), Action::view_down);
    EXPECT_EQ(action_of_hat(0x08), Action::view_left);
    EXPECT_EQ(action_of_hat(0x00), std::nullopt) << "let go";
    EXPECT_EQ(action_of_hat(0x03), std::nullopt) << "between two";
}

TEST(Keys, OtherKeysDoNothing) {
    EXPECT_EQ(action_of('z'), std::nullopt);
    EXPECT_EQ(action_of(0), std::nullopt);
}

TEST(Keys, TheShortHelpIsThatOfTheFirstFlightAndShowsTheWayToTheOther) {
    const std::vector<std::string> lines = help_lines(false);
    EXPECT_LE(lines.size(), 16U);
    EXPECT_THAT(lines, testing::Contains(testing::HasSubstr("all keys")));
}

TEST(Keys, TheHelpNamesEveryKey) {
    const std::vector<std::string> lines = help_lines(true);
    ASSERT_EQ(lines.size(), keys().size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_THAT(lines[i], testing::StartsWith(keys()[i].label));
        EXPECT_THAT(lines[i], testing::EndsWith(keys()[i].says));
    }
}

} // namespace
} // namespace linkdig::tools
