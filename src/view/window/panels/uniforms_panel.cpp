// The section with a widget for each uniform that the Program lines set.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "view/export/hardcopy.h"
#include "view/scene/slider_scale.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr int kMostInRow = 4;
constexpr const char* kNumberFormat = "%.4g";

/// A component of a knob.
struct Part {
    std::size_t index = 0, component = 0;
};

/// The widget's name for `--state` and Sliders::typing.
std::string widgetName(const Knob& knob, std::size_t component) {
    std::string name = "uniform/" + knob.title + "/" + knob.tag;
    return knob.current.size() == 1 ? name : fmt::format("{}/{}", name, component);
}

void markPart(Ui& ui, const Part& part) {
    if (ui.shared.marksWidgets) mark(ui, widgetName(ui.session.knobs()[part.index], part.component));
}

void setPart(Ui& ui, const Part& part, double value) {
    std::vector<double> values = ui.session.knobs()[part.index].current;
    values[part.component] = value;
    ui.session.setValue(part.index, std::move(values));
}

/// A text field in place of the slider, for any value, also beyond the range.
void valueEntry(Ui& ui, const Part& part) {
    double value = ui.session.knobs()[part.index].current[part.component];
    const bool isTyped = sliderEntry(ui, "##slider", value);
    markPart(ui, part);
    if (isTyped) setPart(ui, part, value);
}

/// ImGui's integers have 32 bits.
int shownInteger(double value) {
    return static_cast<int>(std::clamp(value, -2147483648.0, 2147483647.0));
}

/// A menu of the words of a choice.
void wordMenu(Ui& ui, const Part& part) {
    const Knob& knob = ui.session.knobs()[part.index];
    int word = shownInteger(knob.current[part.component]);
    std::string items;  // ended by zero bytes
    for (const std::string& each : knob.words) items += each + '\0';
    const bool isChanged = ImGui::Combo("##slider", &word, items.c_str());
    markPart(ui, part);
    if (isChanged) setPart(ui, part, word);
}

/// Returns true if the user wants the menu of the value.
bool slider(Ui& ui, const Part& part) {
    const Knob& knob = ui.session.knobs()[part.index];
    if (!knob.words.empty()) {
        wordMenu(ui, part);
        return false;
    }
    if (!ui.sliders.typing.empty() && ui.sliders.typing == widgetName(knob, part.component)) {
        valueEntry(ui, part);
        return false;
    }
    double value = knob.current[part.component];
    const SliderUse use = valueSlider(ui, "##slider", scaleOf(knob), value);
    markPart(ui, part);
    const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (use.isActivated && !isSecondClick) ui.sliders.valuesBeforeClick = knob.current;
    if (use.isActivated || use.isChanged) ui.session.animate(part.index, false);
    if (use.isTyped) {
        ui.sliders.typing = widgetName(knob, part.component);
        ui.sliders.typingBegins = true;
        // The first click of the two has moved the slider.
        if (isSecondClick) ui.session.setValue(part.index, ui.sliders.valuesBeforeClick);
    } else if (use.isChanged) {
        setPart(ui, part, value);
    }
    return use.wantsMenu;
}

void number(Ui& ui, const Part& part) {
    const Knob& knob = ui.session.knobs()[part.index];
    double value = knob.current[part.component];
    const auto speed = static_cast<float>(
        knob.isInteger() ? .1 : std::max(.002, std::abs(knob.initial[part.component]) * .005));
    bool changed = false;
    if (knob.isInteger()) {
        int integer = shownInteger(value);
        changed = ImGui::DragInt("##number", &integer, speed);
        value = integer;
    } else {
        changed = ImGui::DragScalar("##number", ImGuiDataType_Double, &value, speed, nullptr, nullptr,
                                    kNumberFormat);
    }
    markPart(ui, part);
    if (changed && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        value = withoutLeftover(value, static_cast<double>(speed));
    if (changed) setPart(ui, part, value);
}

/// The components of a vector side by side; columns of a matrix and elements of an array in rows. Returns
/// true if the user wants the menu of the value.
bool components(Ui& ui, std::size_t index) {
    bool wantsMenu = false;
    const Knob& knob = ui.session.knobs()[index];
    const std::size_t count = knob.current.size();
    const std::size_t inRow =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, knob.type.rows)), 1, kMostInRow);
    const float space = ImGui::GetStyle().ItemInnerSpacing.x;
    const float whole = ImGui::GetContentRegionAvail().x;
    const std::size_t columns = std::min(inRow, count);
    const float each = (whole - space * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % inRow != 0) ImGui::SameLine(0, space);
        ImGui::SetNextItemWidth(std::max(20.F, each));
        ImGui::PushID(static_cast<int>(i));
        if (knob.widget == Widget::slider)
            wantsMenu = slider(ui, {index, i}) || wantsMenu;
        else
            number(ui, {index, i});
        ImGui::PopID();
    }
    return wantsMenu;
}

void checkBox(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    bool on = knob.current.front() != 0;
    if (ImGui::Checkbox("##on", &on))
        ui.session.setValue(index, std::vector<double>(knob.current.size(), on ? 1.0 : 0.0));
    mark(ui, "uniform/{}/{}", knob.title, knob.tag);
}

void color(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    std::array<float, 4> rgba{0, 0, 0, 1};
    const std::size_t count = std::min<std::size_t>(rgba.size(), knob.current.size());
    std::copy_n(knob.current.begin(), count, rgba.begin());
    const bool changed = colorField(ui, widgetName(knob, 0), rgba, count == 4);
    if (!changed) return;
    std::vector<double> values(count);
    // The widget shows three digits, so the value is rounded to them.
    std::transform(rgba.begin(), rgba.begin() + static_cast<std::ptrdiff_t>(count), values.begin(),
                   [](float each) { return std::round(static_cast<double>(each) * 1000) / 1000; });
    ui.session.setValue(index, std::move(values));
}

/// Animations move between the ends of a range.
bool canMove(const Knob& knob) {
    return knob.widget == Widget::slider && knob.words.empty();
}

void contextMenu(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    if (!ImGui::BeginPopup("menu")) return;
    ImGui::TextDisabled("%s", knob.declaration.c_str());
    if (canMove(knob)) {
        const bool isMoving = ui.session.isAnimated(index);
        if (ImGui::MenuItem("Animate", nullptr, isMoving)) ui.session.animate(index, !isMoving);
        mark(ui, "menu/animate");
    }
    if (ImGui::MenuItem("Reset", nullptr, false, knob.isChanged())) ui.session.resetValue(index);
    mark(ui, "menu/reset");
    if (ImGui::MenuItem("Copy for the Program line")) ImGui::SetClipboardText(pairText(knob).c_str());
    if (ImGui::MenuItem("Copy as argument (--set)"))
        ImGui::SetClipboardText(
            ("--set " + setArgument(ui.session.live().scene(), knob, ui.session.knobs())).c_str());
    ImGui::EndPopup();
}

/// The buttons after the value: animate, and back to the scene's value.
void knobButtons(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    const float side = ImGui::GetFrameHeight();
    if (canMove(knob)) {
        const bool isMoving = ui.session.isAnimated(index);
        const bool isPressed = iconButton(
            isMoving ? Icon::pause : Icon::play, "animate",
            isMoving ? "Stop at this value" : "Animate: move between the ends of the range", isMoving);
        if (ui.shared.marksWidgets) markPlace(ui, fmt::format("animate/{}/{}", knob.title, knob.tag));
        if (isPressed) ui.session.animate(index, !isMoving);
    } else {
        ImGui::Dummy({side, side});
    }
    if (!knob.isChanged()) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool isPressed = iconButton(Icon::undo, "reset", "Back to the value of the scene");
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("reset/{}/{}", knob.title, knob.tag));
    if (isPressed) ui.session.resetValue(index);
}

void knobRow(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    ImGui::PushID(static_cast<int>(index));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::Selectable(knob.tag.c_str(), false, ImGuiSelectableFlags_AllowItemOverlap);
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("label/{}/{}", knob.title, knob.tag));
    bool wantsMenu = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s:%d\nRight click: animate, reset or copy", knob.declaration.c_str(),
                          knob.place.file.c_str(), knob.place.line);
    ImGui::TableNextColumn();
    switch (knob.widget) {
        case Widget::checkBox:
            checkBox(ui, index);
            break;
        case Widget::color:
            color(ui, index);
            break;
        case Widget::slider:
        case Widget::numbers:
            wantsMenu = components(ui, index) || wantsMenu;
            break;
    }
    if (wantsMenu) ImGui::OpenPopup("menu");
    contextMenu(ui, index);
    ImGui::TableNextColumn();
    knobButtons(ui, index);
    ImGui::PopID();
}

void valuesOf(Ui& ui, scene::ProgramIndex program) {
    const std::vector<Knob>& knobs = ui.session.knobs();
    if (!ImGui::BeginTable("values", 3, ImGuiTableFlags_None)) return;
    float widest = 0;
    for (const Knob& each : knobs)
        if (each.program == program) widest = std::max(widest, ImGui::CalcTextSize(each.tag.c_str()).x);
    constexpr float kMostForNames = .36F;
    ImGui::TableSetupColumn("tag", ImGuiTableColumnFlags_WidthFixed,
                            std::min(widest, ImGui::GetContentRegionAvail().x * kMostForNames));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("buttons", ImGuiTableColumnFlags_WidthFixed,
                            2 * ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (knobs[i].program == program) knobRow(ui, i);
    ImGui::EndTable();
    if (ImGui::Button(program ? "Copy Program line" : "Copy Let lines"))
        ImGui::SetClipboardText(programLine(ui.session.live().scene(), program, knobs).c_str());
    mark(ui, "copy/{}", program ? std::to_string(program.position()) : "variables");
}

/// Says why there are no values.
void withoutValues(Ui& ui) {
    const scene::Scene& scene = ui.session.live().scene();
    const bool sets = std::any_of(scene.programs.begin(), scene.programs.end(),
                                  [](const scene::Program& each) { return !each.uniforms.empty(); });
    const bool isWrong = hasError(ui.session.diagnostics());
    const char* text = "The scene sets no values.";
    if (sets && isWrong)
        text = "The program does not compile, so its values are not known.";
    else if (sets)
        text = "No program uses a value that its Program line sets.";
    else if (isWrong)
        text = "The scene has errors, so its values are not known.";
    ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().dim));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
    mark(ui, "uniforms/none: {}", text);
}

void uniformsPanel(Ui& ui) {
    if (!section(ui, "Values", "uniforms", true)) return;
    const std::vector<Knob>& knobs = ui.session.knobs();
    if (knobs.empty()) {
        withoutValues(ui);
        return;
    }
    if (ImGui::Button("Reset all")) ui.session.resetValues();
    mark(ui, "uniforms/reset");
    continueRowForButton("Copy values");
    if (ImGui::Button("Copy values")) ImGui::SetClipboardText(setArguments(ui.session).c_str());
    mark(ui, "uniforms/copyValues");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Copy the changed values as arguments for `glibra render`: --set NAME=VALUE ...");
    continueRowForButton("Save values");
    if (ImGui::Button("Save values")) saveScene(ui);
    mark(ui, "scene/save");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Write the current values into the Program lines of the .glib file");
    continueRowForCheck("Labels");
    ImGui::Checkbox("Labels", &ui.shared.showLabels);
    mark(ui, "uniforms/labels");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show the values over the picture (L)");
    std::optional<scene::ProgramIndex> drawn;
    for (const Knob& first : knobs) {
        const scene::ProgramIndex last = first.program;
        if (last == drawn) continue;
        drawn = last;
        ImGui::PushID(last ? static_cast<int>(last.position()) : -1);
        const char* state = last && ui.session.live().showsEarlierProgram(last) ? " (last good version)" : "";
        // In every frame, so without the heap.
        std::array<char, 160> title{};
        fmt::format_to_n(title.data(), title.size() - 1, "{}{}###program", first.title, state);
        std::array<char, 160> name{};
        fmt::format_to_n(name.data(), name.size() - 1, "section/{}", first.title);
        if (group(ui, title.data(), name.data())) valuesOf(ui, last);
        ImGui::PopID();
    }
}

constexpr auto kValueKeys = std::to_array<Shortcut>({
    {KeyGroup::values, GLFW_KEY_R, true, "Ctrl+R", "reset all values",
     [](Ui& ui, Panel&) { ui.session.resetValues(); }},
    {KeyGroup::values, GLFW_KEY_L, false, "L", "show values over the picture",
     [](Ui& ui, Panel&) { ui.shared.showLabels = !ui.shared.showLabels; }},
});

}  // namespace

const PanelRow kValuesRow{
    .name = "uniforms", .place = PanelPlace::section, .make = make<Drawn<uniformsPanel>>, .keys = kValueKeys};

}  // namespace glibra::view
