// The command palette: finds every action by its name, and carries it out.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
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

const PanelRow kCommandPaletteRow{.name = "palette",
                                  .place = PanelPlace::floating,
                                  .make = make<CommandPalette>,
                                  .isShared = true,
                                  .keys = kPaletteKeys,
                                  .title = "Commands"};

}  // namespace glibra::view
