// The list of keys and of what the mouse does.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "view/window/panels/shortcuts.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"

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

// The command palette: finds every action by its name, and carries it out.

struct Command {
    std::string what, keys;
    Panel* panel = nullptr;
    void (*act)(Ui&, Panel&) = nullptr;
    bool withShift = false;
};

std::vector<std::string_view> split(std::string_view text, std::string_view between) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(between);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + between.size());
    }
}

std::string capital(std::string_view text) {
    std::string words(text);
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

/// What ImGui shows of a title, which ends with an id.
std::string_view shownTitle(std::string_view title) {
    return title.substr(0, title.find("##"));
}

/// All shortcuts, also those without a key, and the tool windows. A row for two keys is two commands.
std::vector<Command> commandsOf(const Ui& ui) {
    std::vector<Command> commands;
    for (const PanelUse& use : ui.panels) {
        for (const Shortcut& each : use.row->keys) {
            if (*each.what == 0) continue;
            const std::vector<std::string_view> keys = split(each.keys, ", "), whats = split(each.what, "; ");
            if (keys.size() != whats.size() || keys.size() < 2) {
                commands.push_back({capital(each.what), each.keys, use.panel, each.act, false});
                continue;
            }
            for (std::size_t i = 0; i < keys.size(); ++i)
                commands.push_back({capital(whats[i]), std::string(keys[i]), use.panel, each.act,
                                    keys[i].find("Shift+") != std::string_view::npos});
        }
        if (use.row->title == nullptr) continue;
        const bool hasKey =
            std::ranges::any_of(use.row->keys, [](const Shortcut& each) { return each.act == toggleOpen; });
        if (!hasKey)
            commands.push_back(
                {fmt::format("Window '{}'", shownTitle(use.row->title)), "", use.panel, toggleOpen, false});
    }
    return commands;
}

bool holdsWord(std::string_view text, std::string_view word) {
    return std::search(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) ==
                      std::tolower(static_cast<unsigned char>(b));
           }) != text.end();
}

/// True if it has all words of the search.
bool matches(const Command& command, std::string_view words) {
    const std::vector<std::string_view> all = split(words, " ");
    return std::ranges::all_of(all, [&](std::string_view each) {
        return holdsWord(command.what, each) || holdsWord(command.keys, each);
    });
}

class CommandPalette final : public Panel {
  public:
    void work(Ui& ui) override {
        if (!pending_ || pendingIn_ != &ui) return;
        const Command command = *std::exchange(pending_, std::nullopt);
        bool& shift = ImGui::GetIO().KeyShift;
        const bool before = std::exchange(shift, command.withShift);
        command.act(ui, *command.panel);
        shift = before;
    }
    [[nodiscard]] bool isWorking() const override { return pending_.has_value(); }

    void show(Ui& ui) override {
        if (!isOpen) {
            isShown_ = false;
            return;
        }
        const bool isNew = !std::exchange(isShown_, true);
        if (isNew) {
            words_[0] = 0;
            chosen_ = 0;
            commands_ = commandsOf(ui);
        }
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float width = std::min(screen.x, 560 * ui.shared.scale);
        ImGui::SetNextWindowPos({screen.x / 2, std::min(60 * ui.shared.scale, screen.y / 8)},
                                ImGuiCond_Always, {.5F, 0});
        ImGui::SetNextWindowSize({width, std::min(screen.y * .8F, 420 * ui.shared.scale)});
        if (isNew) ImGui::SetNextWindowFocus();
        if (ImGui::Begin(kCommandPaletteRow.title, &isOpen,
                         ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                             ImGuiWindowFlags_NoSavedSettings))
            list(ui, isNew);
        ImGui::End();
    }

    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["palette"] = {{"open", isOpen}, {"found", isOpen ? found_ : std::vector<std::string>()}};
    }

  private:
    void list(Ui& ui, bool isNew) {
        if (isNew) giveKeyboardToNext();
        ImGui::SetNextItemWidth(-1);
        const bool isEntered = ImGui::InputTextWithHint(
            "##words", "what to do", words_.data(), words_.size(),
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
            [](ImGuiInputTextCallbackData*) { return 0; });
        mark(ui, "palette/words");
        if (std::string_view(words_.data()) != before_) chosen_ = 0;
        before_ = words_.data();
        std::vector<const Command*> shown;
        for (const Command& each : commands_)
            if (matches(each, words_.data())) shown.push_back(&each);
        const int last = static_cast<int>(shown.size()) - 1;
        const int step = isKeyPressed(GLFW_KEY_DOWN) ? 1 : isKeyPressed(GLFW_KEY_UP) ? -1 : 0;
        chosen_ = std::clamp(chosen_ + step, 0, std::max(0, last));
        found_.clear();
        ImGui::BeginChild("commands");
        for (int i = 0; i <= last; ++i) {
            const Command& each = *shown[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            const bool isClicked = ImGui::Selectable(each.what.c_str(), i == chosen_);
            mark(ui, "palette/{}", i);
            if (i == chosen_ && step != 0) ImGui::SetScrollHereY();
            const float right = ImGui::GetWindowContentRegionMax().x;
            ImGui::SameLine(right - ImGui::CalcTextSize(each.keys.c_str()).x);
            ImGui::TextDisabled("%s", each.keys.c_str());
            ImGui::PopID();
            found_.push_back(each.what);
            if (!isClicked && !(isEntered && i == chosen_)) continue;
            pending_ = each;
            pendingIn_ = &ui;
            isOpen = false;
        }
        if (shown.empty()) ImGui::TextDisabled("nothing is called so");
        ImGui::EndChild();
    }

    std::vector<Command> commands_;
    std::vector<std::string> found_;
    std::array<char, 128> words_{};
    std::string before_;
    int chosen_ = 0;
    bool isShown_ = false;
    std::optional<Command> pending_;
    const Ui* pendingIn_ = nullptr;
};

constexpr auto kPaletteKeys =
    std::to_array<Shortcut>({{KeyGroup::window, GLFW_KEY_P, true, "Ctrl+Shift+P",
                              "command palette: find an action by its name", toggleOpen, true}});

}  // namespace

const PanelRow kHelpRow{.name = "help",
                        .place = PanelPlace::floating,
                        .make = make<Drawn<helpWindow>>,
                        .isShared = true,
                        .keys = kHelpKeys,
                        .title = "Keys and mouse"};

const PanelRow kCommandPaletteRow{.name = "palette",
                                  .place = PanelPlace::floating,
                                  .make = make<CommandPalette>,
                                  .isShared = true,
                                  .keys = kPaletteKeys,
                                  .title = "Commands"};

}  // namespace glibra::view
