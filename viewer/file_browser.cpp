// Lists folders and the files that an importer claims.
#include "viewer/file_browser.h"

#include "importers/load.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace quartic::viewer {
namespace {

namespace fs = std::filesystem;

bool is_model(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Importer& importer : importer_table()) {
        for (const std::string_view known : importer.extensions) {
            if (!extension.empty() && extension.substr(1) == known) {
                return true;
            }
        }
    }
    return false;
}

std::string size_text(std::uintmax_t bytes) {
    return bytes < 1024 * 1024 ? std::to_string((bytes + 1023) / 1024) + " KiB"
                               : std::to_string(bytes / (1024 * 1024)) + " MiB";
}

}  // namespace

void FileBrowser::open(const std::string& beside) {
    std::error_code error;
    const fs::path folder =
        beside.empty() ? fs::current_path(error) : fs::absolute(beside, error).parent_path();
    is_open_ = true;
    typed_.clear();
    go_to(error ? fs::path("/") : folder);
}

void FileBrowser::go_to(const fs::path& folder) {
    std::error_code error;
    std::vector<Entry> entries;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;  // entries that vanish or are forbidden are files of no size
        const std::string name = at->path().filename().string();
        const bool is_folder = at->is_directory(ignored);
        if (name.starts_with('.') || (!is_folder && !all_files_ && !is_model(at->path()))) {
            continue;
        }
        const std::uintmax_t bytes = is_folder ? 0 : at->file_size(ignored);
        entries.push_back({name, is_folder || ignored ? "" : size_text(bytes), is_folder});
    }
    if (error) {
        complaint_ = folder.string() + ": " + error.message();
        return;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    complaint_.clear();
    folder_ = folder;
    entries_ = std::move(entries);
}

// A folder is entered, a file is the answer.
std::optional<std::string> FileBrowser::choose(const std::string& path) {
    std::error_code error;
    const fs::path full = fs::path(path).is_absolute() ? fs::path(path) : folder_ / path;
    if (fs::is_directory(full, error)) {
        go_to(full.lexically_normal());
        typed_.clear();
        return {};
    }
    if (!fs::exists(full, error)) {
        complaint_ = full.string() + ": there is no such file";
        return {};
    }
    is_open_ = false;
    return full.string();
}

std::optional<std::string> FileBrowser::show_entries() {
    std::string chosen;
    const float foot =
        2.0f * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
    if (ImGui::BeginTable("entries", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY,
                          ImVec2(0.0f, -foot))) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(entries_.size()));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const Entry& entry = entries_[static_cast<std::size_t>(i)];
                const std::string label = entry.name + (entry.is_folder ? "/" : "");
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::PushID(i);
                if (ImGui::Selectable(label.c_str(), typed_ == entry.name,
                                      ImGuiSelectableFlags_SpanAllColumns |
                                          ImGuiSelectableFlags_AllowDoubleClick)) {
                    typed_ = entry.name;
                    chosen = ImGui::IsMouseDoubleClicked(0) || entry.is_folder ? entry.name : "";
                }
                ImGui::PopID();
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(entry.size.c_str());
            }
        }
        ImGui::EndTable();
    }
    return chosen.empty() ? std::nullopt : choose(chosen);
}

std::optional<std::string> FileBrowser::show(double scale) {
    if (!is_open_) {
        return {};
    }
    const char* const title = "Open a model";
    if (!ImGui::IsPopupOpen(title)) {
        ImGui::OpenPopup(title);
    }
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    const auto factor = static_cast<float>(scale);
    ImGui::SetNextWindowPos(centre, ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(700.0f * factor, 480.0f * factor), ImGuiCond_Appearing);
    std::optional<std::string> chosen;
    if (ImGui::BeginPopupModal(title, &is_open_, ImGuiWindowFlags_NoSavedSettings)) {
        if (ImGui::Button("Up")) {
            go_to(folder_.parent_path());
        }
        ImGui::SameLine();
        ImGui::TextUnformatted(folder_.c_str());
        chosen = show_entries();
        ImGui::TextUnformatted(complaint_.c_str());
        ImGui::SetNextItemWidth(-1.0f);
        if (ImGui::IsWindowAppearing()) {
            ImGui::SetKeyboardFocusHere();
        }
        const bool entered = ImGui::InputTextWithHint("##name", "name or path", &typed_,
                                                      ImGuiInputTextFlags_EnterReturnsTrue);
        if (ImGui::Checkbox("All files", &all_files_)) {
            go_to(fs::path(folder_));
        }
        ImGui::SameLine();
        const bool pressed = ImGui::Button("Open");
        ImGui::SameLine();
        is_open_ = !ImGui::Button("Cancel") && is_open_;
        if ((pressed || entered) && !chosen && !typed_.empty()) {
            chosen = choose(std::string(typed_));
        }
        if (!is_open_) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    return chosen;
}

}  // namespace quartic::viewer
