// The real window on a screen of its own, driven by xdotool; its title tells what is selected.
#include "viewer/viewer.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace quartic {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 90s;  // software OpenGL on a busy machine

// The middle of the model's picture and a corner of it, in a window of 1400 x 900.
constexpr const char* middle = "680 450";
constexpr const char* corner = "345 60";

const std::string sphere =
    "HEAD\n 1 1\nprogram\nnote\ndate\nuser\nMODL\n 1 1\nP\n/M\n"
    "CNTB\n 1 1\n/TEST-SPHERE\n 0.0 0.0 0.0\n 2\n"
    "PRIM\n 1 1\n 9\n 0.001 0 0 5\n 0 0.001 0 6\n 0 0 0.001 7\n"
    "-500 -500 -500\n 500 500 500\n 1000\nCNTE\n 1 1\nEND:\n 1 1\n";

// What a command prints; empty too if it fails.
std::string output_of(const std::string& command) {
    std::string text;
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return text;
    }
    char buffer[256];
    while (std::fgets(buffer, sizeof(buffer), pipe) != nullptr) {
        text += buffer;
    }
    ::pclose(pipe);
    return text.substr(0, text.find('\n'));
}

bool is_installed(const std::string& program) {
    return !output_of("command -v " + program).empty();
}

void end_process(pid_t process) {
    if (process > 0) {
        ::kill(process, SIGTERM);
        ::waitpid(process, nullptr, 0);
    }
}

// Xvfb on the first free display; it writes the number into the pipe when it is ready.
class Screen {
public:
    Screen() {
        int ends[2] = {};
        if (::pipe(ends) != 0) {
            return;
        }
        process_ = ::fork();
        if (process_ == 0) {
            ::close(ends[0]);
            const std::string number = std::to_string(ends[1]);
            ::execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1000x24",
                     "-nolisten", "tcp", nullptr);
            ::_exit(127);
        }
        ::close(ends[1]);
        std::string number;
        for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';) {
            number += c;
        }
        ::close(ends[0]);
        name_ = number.empty() ? "" : ":" + number;
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    ~Screen() { end_process(process_); }

    const std::string& name() const { return name_; }

private:
    pid_t process_ = -1;
    std::string name_;
};

// In a process of its own, since GLFW and its display belong to one.
pid_t start_viewer(const std::string& display, const std::vector<std::string>& files) {
    const pid_t process = ::fork();
    if (process == 0) {
        ::setenv("DISPLAY", display.c_str(), 1);
        ViewerOptions options;
        options.files = files;
        options.software = true;
        const Result<int> code = run_viewer(options);
        ::_exit(code ? code.value() : 100 + static_cast<int>(code.error().kind));
    }
    return process;
}

int code_of(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class WindowTest : public testing::Test {
protected:
    void SetUp() override {
        for (const char* const program : {"Xvfb", "xdotool"}) {
            if (!is_installed(program)) {
                GTEST_SKIP() << "NOT TESTED: " << program
                             << " is not installed, so no window can be opened";
            }
        }
        screen_ = std::make_unique<Screen>();
        ASSERT_FALSE(screen_->name().empty()) << "Xvfb does not start";
        folder_ = std::filesystem::temp_directory_path() /
                  ("quartic-window-" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
        const std::string model = (folder_ / "tiny.rev").string();
        std::ofstream(model) << sphere;
        viewer_ = start_viewer(screen_->name(), {model});
        ASSERT_TRUE(wait_for([&] { return title() == "tiny.rev - Quartic"; })) << title();
    }
    void TearDown() override {
        if (viewer_ > 0) {
            end_process(viewer_);
        }
        screen_.reset();
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::string xdotool(const std::string& words) const {
        return output_of("DISPLAY=" + screen_->name() + " xdotool " + words + " 2>/dev/null");
    }
    std::string title() const { return xdotool("search --name Quartic getwindowname"); }
    bool is_selected() const { return title().find("/TEST-SPHERE (sphere)") == 0; }
    bool is_running() const { return ::waitpid(viewer_, nullptr, WNOHANG) == 0; }
    void click(const std::string& place) const { xdotool("mousemove " + place + " click 1"); }

    template <class Condition>
    static bool wait_for(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) {
                return false;
            }
            std::this_thread::sleep_for(100ms);
        }
        return true;
    }
    // Again and again: the first picture may not be there yet.
    bool select_sphere() const {
        return wait_for([&] {
            click(middle);
            std::this_thread::sleep_for(200ms);
            return is_selected();
        });
    }
    int quit() {
        xdotool("key ctrl+q");
        const int code = code_of(viewer_);
        viewer_ = -1;
        return code;
    }

    std::unique_ptr<Screen> screen_;
    std::filesystem::path folder_;
    pid_t viewer_ = -1;
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
    EXPECT_EQ(code_of(start_viewer("", {"a.rvm", "b.rvm"})),
              100 + static_cast<int>(ErrorKind::io));
}

}  // namespace
}  // namespace quartic
