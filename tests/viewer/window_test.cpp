// The real window: clicks, drags, keys and sizes.
#include "diagnostics/result.h"
#include "tests/viewer/window_fixture.h"

namespace quartic {
namespace {

using namespace std::chrono_literals;

// The middle of the model's picture and a corner of it, in a window of 1400 x 900.
constexpr const char* middle = "680 450";
constexpr const char* corner = "345 60";

const std::string sphere =
    "HEAD\n 1 1\nprogram\nnote\ndate\nuser\nMODL\n 1 1\nP\n/M\n"
    "CNTB\n 1 1\n/TEST-SPHERE\n 0.0 0.0 0.0\n 2\n"
    "PRIM\n 1 1\n 9\n 0.001 0 0 5\n 0 0.001 0 6\n 0 0 0.001 7\n"
    "-500 -500 -500\n 500 500 500\n 1000\nCNTE\n 1 1\nEND:\n 1 1\n";

class WindowTest : public OpenWindow {
protected:
    WindowTest() : OpenWindow("tiny.rev", sphere) {}

    bool is_selected() const { return title().find("/TEST-SPHERE (sphere)") == 0; }
    // Again and again: the first picture may not be there yet.
    bool select_sphere() const {
        return wait_for([&] {
            click(middle);
            std::this_thread::sleep_for(200ms);
            return is_selected();
        });
    }
};

TEST_F(WindowTest, click_selects_escape_clears_and_control_q_quits) {
    ASSERT_TRUE(select_sphere()) << title();
    xdotool("key Escape");
    EXPECT_TRUE(wait_for([&] { return !is_selected(); }));
    xdotool("key Escape key Escape key Escape");
    ASSERT_TRUE(select_sphere()) << "Esc with nothing selected must not quit: " << title();
    click(corner);
    EXPECT_TRUE(wait_for([&] { return !is_selected(); })) << "the background selects nothing";
    EXPECT_TRUE(is_running());
    EXPECT_EQ(quit(), 0);
}

TEST_F(WindowTest, drags_do_not_select_and_fit_brings_the_model_back) {
    ASSERT_TRUE(select_sphere());
    xdotool("key Escape");
    EXPECT_TRUE(wait_for([&] { return !is_selected(); }));
    xdotool("mousemove 680 450 mousedown 2 mousemove 800 500 mousemove 1000 880 mouseup 2");
    xdotool("mousemove 500 300 mousedown 1 mousemove 520 320 mousemove 600 350 mouseup 1");
    click(middle);
    std::this_thread::sleep_for(2s);
    EXPECT_FALSE(is_selected()) << "panned away";
    xdotool("key f");
    EXPECT_TRUE(select_sphere()) << title();
    EXPECT_EQ(quit(), 0);
}

TEST_F(WindowTest, sizes_from_one_pixel_to_the_screen_are_survived) {
    const std::string window = xdotool("search --name Quartic");
    for (const char* const size : {"1 1", "30 20", "300 2", "1600 1000", "2 900", "640 400"}) {
        xdotool("windowsize " + window + " " + size);
        std::this_thread::sleep_for(100ms);
    }
    xdotool("windowunmap " + window + " windowmap --sync " + window);
    xdotool("windowsize --sync " + window + " 1400 900 windowfocus --sync " + window);
    xdotool("key f");
    EXPECT_TRUE(select_sphere()) << title();
    EXPECT_EQ(quit(), 0);
}

TEST_F(WindowTest, keys_and_wheel_leave_the_sphere_in_the_middle) {
    ASSERT_TRUE(select_sphere());
    xdotool("key 5 key 7 key ctrl+3 key 9 key F1 key Escape key e key a key shift+f");
    xdotool("mousemove 680 450 click --repeat 5 4 click --repeat 9 5");
    xdotool("key Escape");
    EXPECT_TRUE(wait_for([&] { return !is_selected(); }));
    EXPECT_TRUE(select_sphere());
    EXPECT_EQ(quit(), 0);
}

TEST(WindowWithoutScreen, is_an_error_of_kind_no_opengl) {
    EXPECT_EQ(code_of(start_viewer("", {})), 100 + static_cast<int>(ErrorKind::no_opengl));
}

TEST(WindowWithoutScreen, missing_file_is_told_before_a_window_opens) {
    EXPECT_EQ(code_of(start_viewer("", {"/does/not/exist.rvm"})),
              100 + static_cast<int>(ErrorKind::io));
}

TEST(WindowWithoutScreen, the_first_of_several_files_that_is_missing_is_an_error) {
    EXPECT_EQ(code_of(start_viewer("", {"a.rvm", "b.rvm"})), 100 + static_cast<int>(ErrorKind::io));
}

}  // namespace
}  // namespace quartic
