// A neutral grey theme with a legible font.
#include "viewer/theme.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace quartic::viewer {
namespace {

constexpr float font_px = 16.0f;

// Names of plants are Latin, Greek or Cyrillic; punctuation, arrows and the diameter sign beside
// them.
constexpr ImWchar glyphs[] = {0x20,   0x17f,  0x370,  0x4ff,  0x2010, 0x2044,
                              0x2190, 0x21ff, 0x2300, 0x2300, 0};

// Where Debian, Fedora, Arch and macOS keep a plain sans-serif font.
constexpr std::array fonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/Library/Fonts/Arial.ttf",
};

void load_font(double scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const float size = font_px * static_cast<float>(scale);
    for (const char* const path : fonts) {
        std::error_code ignored;  // an unreadable font is no font
        if (std::filesystem::exists(path, ignored) &&
            atlas.AddFontFromFileTTF(path, size, nullptr, glyphs) != nullptr) {
            return;
        }
    }
    ImFontConfig built_in;
    built_in.SizePixels = size;
    atlas.AddFontDefault(&built_in);
}

void choose_colours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    const auto grey = [](float value, float alpha = 1.0f) {
        return ImVec4(value, value, value, alpha);
    };
    const ImVec4 accent(0.27f, 0.45f, 0.65f, 1.0f);
    const ImVec4 bright(0.33f, 0.54f, 0.77f, 1.0f);
    ImVec4* const colours = style.Colors;
    colours[ImGuiCol_Text] = grey(0.92f);
    colours[ImGuiCol_TextDisabled] = grey(0.64f);
    colours[ImGuiCol_WindowBg] = grey(0.17f);
    colours[ImGuiCol_PopupBg] = grey(0.19f);
    colours[ImGuiCol_MenuBarBg] = grey(0.22f);
    colours[ImGuiCol_Border] = grey(0.32f);
    colours[ImGuiCol_FrameBg] = grey(0.26f);
    colours[ImGuiCol_FrameBgHovered] = grey(0.31f);
    colours[ImGuiCol_FrameBgActive] = grey(0.34f);
    colours[ImGuiCol_TitleBg] = grey(0.22f);
    colours[ImGuiCol_TitleBgActive] = grey(0.28f);
    colours[ImGuiCol_Button] = grey(0.32f);
    colours[ImGuiCol_ButtonHovered] = grey(0.40f);
    colours[ImGuiCol_ButtonActive] = accent;
    colours[ImGuiCol_Header] = accent;
    colours[ImGuiCol_HeaderHovered] = grey(0.33f);
    colours[ImGuiCol_HeaderActive] = bright;
    colours[ImGuiCol_Tab] = grey(0.22f);
    colours[ImGuiCol_TabHovered] = grey(0.40f);
    colours[ImGuiCol_TabActive] = grey(0.33f);
    colours[ImGuiCol_CheckMark] = bright;
    colours[ImGuiCol_PlotHistogram] = bright;
    colours[ImGuiCol_TableHeaderBg] = grey(0.25f);
    colours[ImGuiCol_TableRowBg] = grey(0.0f, 0.0f);
    colours[ImGuiCol_TableRowBgAlt] = grey(1.0f, 0.03f);
    colours[ImGuiCol_TableBorderLight] = grey(0.28f);
    colours[ImGuiCol_TableBorderStrong] = grey(0.34f);
    colours[ImGuiCol_SeparatorHovered] = accent;
    colours[ImGuiCol_SeparatorActive] = bright;
    colours[ImGuiCol_ResizeGrip] = grey(0.0f, 0.0f);
    colours[ImGuiCol_ResizeGripHovered] = accent;
    colours[ImGuiCol_ResizeGripActive] = bright;
    colours[ImGuiCol_ModalWindowDimBg] = grey(0.0f, 0.35f);
    colours[ImGuiCol_NavHighlight] = bright;
}

}  // namespace

void apply_theme(double scale) {
    ImGuiStyle style;
    choose_colours(style);
    style.FramePadding = ImVec2(6.0f, 4.0f);
    style.WindowPadding = ImVec2(8.0f, 8.0f);
    style.ItemSpacing = ImVec2(8.0f, 4.0f);
    style.FrameRounding = 2.0f;
    style.PopupRounding = 3.0f;
    style.ScrollbarSize = 13.0f;
    style.ScaleAllSizes(static_cast<float>(scale));
    ImGui::GetStyle() = style;
    load_font(scale);
}

}  // namespace quartic::viewer
