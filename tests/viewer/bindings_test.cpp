// The table of keys: every action has a key and a text, no key has two meanings, Esc does not quit.
#include "viewer/bindings.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace quartic::viewer {
namespace {

constexpr int key_escape = 256;
constexpr int modifier_control = 2;

TEST(Bindings, every_action_has_a_key_and_a_text) {
    ASSERT_EQ(action_table().size(), static_cast<std::size_t>(Action::quit) + 1);
    for (const ActionRow& row : action_table()) {
        EXPECT_FALSE(keys_of(row.action).empty()) << row.text;
        EXPECT_FALSE(row.text.empty());
    }
}

TEST(Bindings, no_key_has_two_meanings) {
    std::set<std::string> seen;
    for (const ActionRow& row : action_table()) {
        std::istringstream list(keys_of(row.action));
        for (std::string key; std::getline(list >> std::ws, key, ',');) {
            EXPECT_TRUE(seen.insert(key).second) << key;
        }
    }
}

TEST(Bindings, escape_cancels_and_only_control_q_quits) {
    EXPECT_EQ(find_action(key_escape, 0), Action::cancel);
    EXPECT_EQ(find_action('Q', modifier_control), Action::quit);
    EXPECT_EQ(find_action('Q', 0), std::nullopt);
    EXPECT_EQ(keys_of(Action::quit), "Ctrl+Q");
}

TEST(Bindings, question_mark_is_found_as_a_character) {
    EXPECT_EQ(find_action_of_character('?'), Action::toggle_help);
    EXPECT_EQ(find_action_of_character(0), std::nullopt);
    EXPECT_EQ(keys_of(Action::toggle_help), "F1, H, ?");
}

TEST(Bindings, shift_and_left_button_pan) {
    EXPECT_EQ(find_gesture(0, 1), Gesture::pan);
    EXPECT_EQ(find_gesture(0, 0), Gesture::orbit);
    EXPECT_EQ(find_gesture(2, 0), Gesture::pan);
}

}  // namespace
}  // namespace quartic::viewer
