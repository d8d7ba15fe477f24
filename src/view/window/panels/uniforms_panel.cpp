// The section with a widget for each uniform that the Program lines set.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "glib/text.h"
#include "render/live/knobs.h"
#include "view/export/hardcopy.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/label_overlay.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/uniform_rows.h"
#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// Rows of the knobs for which `isShown` is true.
template <class IsShown>
void rows(Ui& ui, const IsShown& isShown) {
    const std::vector<render::Knob>& knobs = ui.session.knobs();
    float widest = 0;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (isShown(i)) widest = std::max(widest, ImGui::CalcTextSize(knobs[i].tag.c_str()).x);
    if (widest == 0 || !beginRows(widest)) return;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (isShown(i)) knobRow(ui, i);
    ImGui::EndTable();
}

/// Says why there are no values.
void withoutValues(Ui& ui) {
    const scene::Scene& scene = ui.session.live().scene();
    const bool sets = std::ranges::any_of(scene.programs,
                                          [](const scene::Program& each) { return !each.uniforms.empty(); });
    const bool isWrong = hasError(ui.session.diagnostics());
    const char* text = "The scene sets no values.";
    if (sets && isWrong)
        text = "The program does not compile, so its values are not known.";
    else if (sets)
        text = "No program uses a value that its Program line sets.";
    else if (isWrong)
        text = "The scene has errors, so its values are not known.";
    wrappedText(palette().dim, text);
    mark(ui, "uniforms/none: {}", text);
}

/// Which values are labelled on the picture.
void labelControls(Ui& ui) {
    continueRowForCheck("Labels");
    checkBox(ui, "Labels", "uniforms/labels", ui.shared.showLabels, "Show the values over the picture (L)");
    if (!ui.shared.showLabels) return;
    constexpr const char* kLongest = "changed";
    const float width =
        ImGui::CalcTextSize(kLongest).x + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
    continueRow(width);
    labelChoice(ui, "##which", "uniforms/labelChoice", width);
}

class ValuesPanel final : public Panel {
  public:
    void show(Ui& ui) override {
        if (!section(ui, "Values", "uniforms", true)) return;
        const std::vector<render::Knob>& knobs = ui.session.knobs();
        if (knobs.empty()) return withoutValues(ui);
        if (std::exchange(loaded_, ui.session.timesLoaded()) != ui.session.timesLoaded()) {
            shared_ = sharedKnobs(knobs);
            isShared_.assign(knobs.size(), false);
            for (const auto& group : shared_)
                for (const std::size_t each : group) isShared_[each] = true;
        }
        if (button(ui, "Reset all", "uniforms/reset")) ui.session.resetValues();
        continueRowForButton("Copy values");
        if (button(ui, "Copy values", "uniforms/copyValues",
                   "Copy the changed values as arguments for `glibra render`: --set NAME=VALUE ..."))
            ImGui::SetClipboardText(setArguments(ui.session).c_str());
        continueRowForButton("Save values");
        if (button(ui, "Save values", "scene/save",
                   "Write the current values into the Program lines of the .glib file"))
            saveScene(ui);
        labelControls(ui);
        filterEntry(ui);
        allGroups(ui);
    }

  private:
    void filterEntry(Ui& ui) {
        constexpr std::size_t kMany = 12;
        if (ui.session.knobs().size() < kMany) {
            filter_[0] = 0;
            return;
        }
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##filter", "show only values whose names contain ...", filter_.data(),
                                 filter_.size());
        mark(ui, "uniforms/filter");
    }
    [[nodiscard]] bool isFound(const render::Knob& knob) const {
        if (filter_[0] == 0) return true;
        const std::string wanted = glib::lower(filter_.data());
        return glib::lower(knob.tag).find(wanted) != std::string::npos ||
               glib::lower(knob.title).find(wanted) != std::string::npos;
    }

    void allGroups(Ui& ui) {
        const std::vector<render::Knob>& knobs = ui.session.knobs();
        std::optional<scene::ProgramIndex> drawn;
        bool isSharedDrawn = shared_.empty();
        bool isAny = false;
        for (const render::Knob& first : knobs) {
            const scene::ProgramIndex program = first.program;
            if (program == drawn) continue;
            drawn = program;
            if (program && !std::exchange(isSharedDrawn, true)) isAny = sharedGroup(ui) || isAny;
            isAny = programGroup(ui, first) || isAny;
        }
        if (!isAny) ImGui::TextDisabled("No name contains this text.");
    }

    bool sharedGroup(Ui& ui) {
        const std::vector<render::Knob>& knobs = ui.session.knobs();
        float widest = 0;
        for (const auto& each : shared_)
            if (isFound(knobs[each.front()]))
                widest = std::max(widest, ImGui::CalcTextSize(knobs[each.front()].tag.c_str()).x);
        if (widest == 0) return false;
        ImGui::PushID("shared");
        if (group(ui, "Shared by programs###shared", "section/shared") && beginRows(widest)) {
            for (const auto& each : shared_)
                if (isFound(knobs[each.front()])) sharedRow(ui, each);
            ImGui::EndTable();
        }
        ImGui::PopID();
        return true;
    }

    /// The values of the program that are its own, and below a fold those that others have, too. Returns
    /// false if the filter finds none of them.
    bool programGroup(Ui& ui, const render::Knob& first) {
        const std::vector<render::Knob>& knobs = ui.session.knobs();
        const scene::ProgramIndex program = first.program;
        std::size_t sharedCount = 0, count = 0;
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            if (knobs[i].program != program || !isFound(knobs[i])) continue;
            ++count;
            if (isShared_[i]) ++sharedCount;
        }
        if (count == 0) return false;
        ImGui::PushID(program ? static_cast<int>(program.position()) : -1);
        const char* state =
            program && ui.session.live().showsEarlierProgram(program) ? " (last good version)" : "";
        // In every frame, so without the heap.
        std::array<char, 160> title{};
        fmt::format_to_n(title.data(), title.size() - 1, "{}{}###program", first.title, state);
        std::array<char, 160> name{};
        fmt::format_to_n(name.data(), name.size() - 1, "section/{}", first.title);
        if (group(ui, title.data(), name.data())) {
            rows(ui, [&](std::size_t i) {
                return knobs[i].program == program && !isShared_[i] && isFound(knobs[i]);
            });
            if (sharedCount > 0) sharedFold(ui, first, sharedCount);
            if (ImGui::Button(program ? "Copy Program line" : "Copy Let lines"))
                ImGui::SetClipboardText(programLine(ui.session.live().scene(), program, knobs).c_str());
            mark(ui, "copy/{}", program ? std::to_string(program.position()) : "variables");
        }
        ImGui::PopID();
        return true;
    }

    void sharedFold(Ui& ui, const render::Knob& first, std::size_t count) {
        const std::vector<render::Knob>& knobs = ui.session.knobs();
        const std::string title = base::counted(count, "shared value") + " alone###alone";
        const bool isUnfolded = ImGui::TreeNodeEx(
            title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
        mark(ui, "shared/{}", first.title);
        if (!isUnfolded) return;
        ImGui::PushID("alone");
        rows(ui, [&](std::size_t i) {
            return knobs[i].program == first.program && isShared_[i] && isFound(knobs[i]);
        });
        ImGui::PopID();
    }

    std::uint64_t loaded_ = 0;
    std::vector<std::vector<std::size_t>> shared_;
    std::vector<bool> isShared_;
    std::array<char, 64> filter_{};
};

void toggleLabels(Ui& ui, LabelChoice choice) {
    ui.shared.showLabels = !ui.shared.showLabels || ui.settings.labelChoice != choice;
    ui.settings.labelChoice = choice;
}

constexpr auto kValueKeys = std::to_array<Shortcut>({
    {KeyGroup::values, GLFW_KEY_R, true, "Ctrl+R", "reset all values",
     [](Ui& ui, Panel&) { ui.session.resetValues(); }},
    {KeyGroup::values, GLFW_KEY_L, false, "L", "show values over the picture",
     [](Ui& ui, Panel&) { ui.shared.showLabels = !ui.shared.showLabels; }},
    // Without keys: for the list of commands.
    {KeyGroup::values, kNoKey, false, "", "labels of all values",
     [](Ui& ui, Panel&) { toggleLabels(ui, LabelChoice::all); }},
    {KeyGroup::values, kNoKey, false, "", "labels of changed values only",
     [](Ui& ui, Panel&) { toggleLabels(ui, LabelChoice::changed); }},
    {KeyGroup::values, kNoKey, false, "", "copy the changed values as arguments of glibra render",
     [](Ui& ui, Panel&) {
         if (ui.session.hasScene()) ImGui::SetClipboardText(setArguments(ui.session).c_str());
     }},
});

}  // namespace

const PanelRow kValuesRow{
    .name = "uniforms", .place = PanelPlace::section, .make = make<ValuesPanel>, .keys = kValueKeys};

}  // namespace glibra::view
