// Maps, split views and the solvers of materials in the real window.
#include "tests/viewer/window_fixture.h"

namespace quartic {
namespace {

using namespace std::chrono_literals;

// A whole torus of material 2, "colour 2".
const std::string torus =
    "HEAD\n 1 1\nprogram\nnote\ndate\nuser\nMODL\n 1 1\nP\n/M\n"
    "CNTB\n 1 1\n/TEST-TORUS\n 0.0 0.0 0.0\n 2\n"
    "PRIM\n 1 1\n 4\n 0.001 0 0 5\n 0 0.001 0 6\n 0 0 0.001 7\n"
    "-500 -500 -500\n 500 500 500\n 400 150 6.2831853\nCNTE\n 1 1\nEND:\n 1 1\n";

// Places in a window of 1400 x 900.
constexpr const char* solver_menu = "190 12";
constexpr const char* maps_menu = "241 12";

class MapWindowTest : public OpenWindow {
protected:
    MapWindowTest() : OpenWindow("ring.rev", torus) {}

    // Menus open, and their rows answer, a frame after the click that asked for them.
    void choose(const std::vector<std::string>& places) {
        for (const std::string& place : places) {
            click(place);
            std::this_thread::sleep_for(500ms);
        }
    }
    void choose_map(int row) { choose({maps_menu, "240 " + std::to_string(40 + 20 * row)}); }

    // The rows of the menu "Maps".
    static constexpr int picture = 0;
    static constexpr int steps = 1;
    static constexpr int error = 3;
    static constexpr int solver = 4;
    const std::string split_row = "240 164";
};

TEST_F(MapWindowTest, maps_replace_the_picture_and_give_it_back) {
    const std::string before = screenshot();
    ASSERT_FALSE(before.empty());
    choose_map(steps);
    const std::string steps_map = screenshot();
    EXPECT_NE(steps_map, before);
    choose_map(error);
    const std::string error_map = screenshot();
    EXPECT_NE(error_map, before);
    EXPECT_NE(error_map, steps_map);
    choose_map(picture);
    EXPECT_EQ(screenshot(), before);
    EXPECT_EQ(quit(), 0);
}

TEST_F(MapWindowTest, one_material_is_given_a_solver_of_its_own) {
    choose_map(solver);
    const std::string before = screenshot();
    // Materials, colour 2, sturm.
    choose({solver_menu, "230 41", "420 41", "500 120"});
    std::string after;
    EXPECT_TRUE(wait_for([&] {
        after = screenshot();
        return after != before;
    }));
    // Everything by sturm has the same colour.
    choose({solver_menu, "200 164"});
    EXPECT_EQ(screenshot(), after);
    EXPECT_EQ(quit(), 0);
}

TEST_F(MapWindowTest, a_divider_is_dragged_without_moving_the_camera) {
    choose_map(solver);
    const std::string whole = screenshot();
    choose({maps_menu, split_row});
    const std::string split = screenshot();
    EXPECT_NE(split, whole) << "the right half is drawn by another solver";
    xdotool("mousemove 680 300 mousedown 1 mousemove 700 300 mousemove 1039 300 mouseup 1");
    std::this_thread::sleep_for(1s);
    const std::string dragged = screenshot();
    EXPECT_NE(dragged, split);
    choose({maps_menu, split_row});
    EXPECT_EQ(screenshot(), whole) << "the camera stands where it stood";
    EXPECT_EQ(quit(), 0);
}

}  // namespace
}  // namespace quartic
