// The sequence of random numbers is part of the models: it must never change.
#include "generators/random.h"

#include <gtest/gtest.h>

namespace quartic {
namespace {

TEST(Random, the_sequence_is_that_of_splitmix64) {
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317u);
    EXPECT_EQ(random.next(), 3203168211198807973u);
    EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(Random, numbers_stay_within_their_limits) {
    Random random(5);
    bool low = false;
    bool high = false;
    for (int i = 0; i < 10000; ++i) {
        const double value = random.between(-2.0, 3.0);
        ASSERT_GE(value, -2.0);
        ASSERT_LT(value, 3.0);
        const int whole = random.whole(1, 6);
        ASSERT_TRUE(whole >= 1 && whole <= 6);
        low = low || whole == 1;
        high = high || whole == 6;
    }
    EXPECT_TRUE(low && high);
}

TEST(Random, numbered_sequences_differ) {
    EXPECT_NE(Random(1, 0).next(), Random(1, 1).next());
    EXPECT_NE(Random(1, 0).next(), Random(2, 0).next());
}

}  // namespace
}  // namespace quartic
