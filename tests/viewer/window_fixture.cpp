// Starts the screen and the viewer, and talks to them.
#include "tests/viewer/window_fixture.h"

#include "viewer/viewer.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace quartic {
namespace {

bool is_installed(const std::string& program) {
    return !output_of("command -v " + program).empty();
}

void end_process(pid_t process) {
    if (process > 0) {
        ::kill(process, SIGTERM);
        ::waitpid(process, nullptr, 0);
    }
}

std::string file_bytes(const std::filesystem::path& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

}  // namespace

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

// It writes the number of the display into the pipe when it is ready.
Screen::Screen() {
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
Screen::~Screen() {
    end_process(process_);
}

pid_t start_viewer(const std::string& display, const std::vector<std::string>& files) {
    const pid_t process = ::fork();
    if (process == 0) {
        ::setenv("DISPLAY", display.c_str(), 1);
        if (!files.empty() && files.front().starts_with('/')) {
            std::error_code ignored;  // a folder that is not there is what some tests ask for
            std::filesystem::current_path(std::filesystem::path(files.front()).parent_path(),
                                          ignored);
        }
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

void OpenWindow::SetUp() {
    for (const char* const program : {"Xvfb", "xdotool"}) {
        if (!is_installed(program)) {
            GTEST_SKIP() << "NOT TESTED: " << program
                         << " is not installed, so no window can be opened";
        }
    }
    screen_ = std::make_unique<Screen>();
    ASSERT_FALSE(screen_->name().empty()) << "Xvfb does not start";
    folder_ =
        std::filesystem::temp_directory_path() / ("quartic-window-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    const std::string model = (folder_ / name_).string();
    std::ofstream(model) << model_;
    viewer_ = start_viewer(screen_->name(), {model});
    ASSERT_TRUE(wait_for([&] { return title() == name_ + " - Quartic"; })) << title();
}
void OpenWindow::TearDown() {
    if (viewer_ > 0) {
        end_process(viewer_);
    }
    screen_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::string OpenWindow::xdotool(const std::string& words) const {
    return output_of("DISPLAY=" + screen_->name() + " xdotool " + words + " 2>/dev/null");
}

bool OpenWindow::is_running() const {
    return ::waitpid(viewer_, nullptr, WNOHANG) == 0;
}

std::string OpenWindow::screenshot() {
    const std::string stem = std::filesystem::path(name_).stem().string();
    const std::string number = screenshots_ == 0 ? "" : "_" + std::to_string(screenshots_);
    const std::filesystem::path path = folder_ / (stem + number + ".png");
    ++screenshots_;
    xdotool("key F12");
    EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(path); })) << path;
    return file_bytes(path);
}

int OpenWindow::quit() {
    xdotool("key ctrl+q");
    const int code = code_of(viewer_);
    viewer_ = -1;
    return code;
}

}  // namespace quartic
