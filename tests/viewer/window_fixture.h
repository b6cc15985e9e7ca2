// The real window on a screen of its own, driven by xdotool; its title tells what is selected.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace quartic {

constexpr std::chrono::seconds patience{90};  // software OpenGL on a busy machine

// What a command prints; empty too if it fails.
std::string output_of(const std::string& command);

// Xvfb on the first free display.
class Screen {
public:
    Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    ~Screen();

    const std::string& name() const { return name_; }

private:
    pid_t process_ = -1;
    std::string name_;
};

// In a process of its own, since GLFW and its display belong to one, and in the folder of its first
// file, where screenshots go.
pid_t start_viewer(const std::string& display, const std::vector<std::string>& files);
int code_of(pid_t process);

// A window of 1400 x 900 with one model, whose text the test gives.
class OpenWindow : public testing::Test {
protected:
    OpenWindow(std::string name, std::string model)
        : name_(std::move(name)), model_(std::move(model)) {}
    void SetUp() override;
    void TearDown() override;

    std::string xdotool(const std::string& words) const;
    std::string title() const { return xdotool("search --name Quartic getwindowname"); }
    bool is_running() const;
    void click(const std::string& place) const { xdotool("mousemove " + place + " click 1"); }
    // The bytes of the picture that F12 saves once the view has settled.
    std::string screenshot();
    int quit();

    template <class Condition>
    static bool wait_for(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) {
                return false;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return true;
    }

    std::unique_ptr<Screen> screen_;
    std::filesystem::path folder_;
    pid_t viewer_ = -1;

private:
    std::string name_;
    std::string model_;
    int screenshots_ = 0;
};

}  // namespace quartic
