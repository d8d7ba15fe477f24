// The list of keys and of what the mouse does.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "view/window/panels/shortcuts.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr auto kGroups = std::to_array<std::pair<KeyGroup, const char*>>({
    {KeyGroup::time, "Time"},
    {KeyGroup::view, "View"},
    {KeyGroup::values, "Values"},
    {KeyGroup::pipeline, "Look into the pipeline"},
    {KeyGroup::source, "Source"},
    {KeyGroup::scenes, "Scenes and tabs"},
    {KeyGroup::window, "Window"},
});

constexpr auto kMouse = std::to_array<std::pair<const char*, const char*>>({
    {"Left drag", "rotate"},
    {"Ctrl+left or middle drag, wheel", "scale"},
    {"Right or Shift+left drag", "pan"},
    {"Click", "pick the object"},
    {"Double click on a slider", "type any value"},
    {"Shift while dragging a slider", "ten times finer"},
    {"Tab, Shift+Tab", "next slider, previous slider"},
    {"Arrows, PgUp, PgDn, Home, End", "move that slider; Enter types a value"},
    {"Right click on a value", "animate, reset or copy it"},
    {"Drop a scene", "open it in a tab"},
    {"Drop a shader or texture", "show it where the scene uses it"},
    {"Drop a folder", "choose one of its scenes"},
});

/// A group of the list of keys: a heading, and what to press for what.
struct ListedKeys {
    const char* heading;
    std::vector<std::pair<std::string, std::string>> rows;
    std::vector<std::string> marks;  ///< of the first rows, for `--state`

    /// The heading and the space above count as rows.
    [[nodiscard]] std::size_t height() const { return rows.size() + 2; }
};

std::vector<ListedKeys> listedKeys(const Ui& ui) {
    std::vector<ListedKeys> groups;
    if (!sceneKeys(ui).empty()) {
        ListedKeys& own = groups.emplace_back(ListedKeys{"Keys of the scene", {}, {}});
        for (const scene::KeyBinding& each : sceneKeys(ui)) {
            own.rows.emplace_back(each.key, effectOf(each));
            own.marks.push_back("help/key/" + each.key);
        }
    }
    groups.push_back({"Mouse", {kMouse.begin(), kMouse.end()}, {}});
    for (const auto& [wanted, heading] : kGroups) {
        groups.push_back({heading, {}, {}});
        for (const PanelRow* row : panelRows())
            for (const Shortcut& each : row->keys)
                if (each.group == wanted && *each.keys != 0)
                    groups.back().rows.emplace_back(
                        (takenKey(ui, each).empty() ? "" : "Shift+") + std::string(each.keys), each.what);
    }
    return groups;
}

/// Of the column with the keys of a group; what is longer goes on in a second line.
float keyWidth(const ListedKeys& group) {
    float width = 0;
    for (const auto& [keys, what] : group.rows) width = std::max(width, ImGui::CalcTextSize(keys.c_str()).x);
    return std::min(width, ImGui::CalcTextSize("Ctrl+left or middle drag, wheel ").x) +
           ImGui::GetStyle().ItemSpacing.x;
}

void showGroup(Ui& ui, const ListedKeys& group) {
    ImGui::TextDisabled("%s", group.heading);
    mark(ui, "help/{}", group.heading);
    ImGui::Separator();
    if (!ImGui::BeginTable(group.heading, 2)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keyWidth(group));
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", group.rows[i].first.c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", group.rows[i].second.c_str());
        if (i < group.marks.size()) mark(ui, group.marks[i]);
    }
    ImGui::EndTable();
    ImGui::Spacing();
}

void helpWindow(Ui& ui, bool& isOpen) {
    if (!isOpen) return;
    constexpr float kColumnWidth = 340, kMostColumns = 3;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const std::vector<ListedKeys> groups = listedKeys(ui);
    std::size_t rows = 0;
    for (const ListedKeys& each : groups) rows += each.height();
    const float columns =
        std::clamp(std::floor(screen.x / (kColumnWidth * ui.shared.scale)), 1.F, kMostColumns);
    const float rowHeight = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    // Some texts take two lines.
    const float height = 1.35F * static_cast<float>(rows) / columns * rowHeight + 3 * ImGui::GetFrameHeight();
    ImGui::SetNextWindowSize(
        {std::min(screen.x, columns * kColumnWidth * ui.shared.scale), std::min(screen.y, height)},
        ImGuiCond_Always);
    centreNextWindow(ImGuiCond_Appearing);
    if (ImGui::Begin(
            kHelpRow.title, &isOpen,
            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        markWindow(ui, "helpWindow");
        if (ImGui::BeginTable("columns", static_cast<int>(columns))) {
            const auto perColumn =
                (rows + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
            std::size_t inColumn = perColumn;  // the first group begins the first column
            for (const ListedKeys& each : groups) {
                if (inColumn + each.height() / 2 >= perColumn) {
                    ImGui::TableNextColumn();
                    inColumn = 0;
                }
                showGroup(ui, each);
                inColumn += each.height();
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

constexpr auto kHelpKeys =
    std::to_array<Shortcut>({{KeyGroup::window, GLFW_KEY_SLASH, false, "?", "this list", toggleOpen}});

}  // namespace

const PanelRow kHelpRow{.name = "help",
                        .place = PanelPlace::floating,
                        .make = make<Drawn<helpWindow>>,
                        .isShared = true,
                        .keys = kHelpKeys,
                        .title = "Keys and mouse"};

}  // namespace glibra::view
