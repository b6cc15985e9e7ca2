// A small window to choose a file in: always there, whatever the desktop offers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quartic::viewer {

class FileBrowser {
public:
    // Beside that file, or in the current folder.
    void open(const std::string& beside);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }

    // Inside a frame. The file that the user chose just now.
    std::optional<std::string> show(double scale);

private:
    struct Entry {
        std::string name;
        std::string size;
        bool is_folder = false;
    };
    void go_to(const std::filesystem::path& folder);
    std::optional<std::string> show_entries();
    std::optional<std::string> choose(const std::string& path);

    bool is_open_ = false;
    bool all_files_ = false;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string typed_;
    std::string complaint_;
};

}  // namespace quartic::viewer
