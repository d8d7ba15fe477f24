// The section with a widget for each uniform that the Program lines set.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "view/edit/save_values.h"
#include "view/export/hardcopy.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr int kMostInRow = 4;
constexpr const char* kNumberFormat = "%.4g";

/// A component of a knob.
struct Part {
    std::size_t index = 0, component = 0;
};

/// The widget's name for `--state` and Ui::typing.
std::string nameOf(const Knob& knob, std::size_t component) {
    std::string name = "uniform/" + knob.title + "/" + knob.tag;
    return knob.current.size() == 1 ? name : fmt::format("{}/{}", name, component);
}

void markPart(Ui& ui, const Part& part) {
    if (ui.shared.marksWidgets) mark(ui, nameOf(ui.session.knobs()[part.index], part.component));
}

void setPart(Ui& ui, const Part& part, double value) {
    std::vector<double> values = ui.session.knobs()[part.index].current;
    values[part.component] = value;
    ui.session.setValue(part.index, std::move(values));
}

/// A text field in place of the slider, for any value, also beyond the range.
void entry(Ui& ui, const Part& part) {
    const bool begins = std::exchange(ui.typingBegins, false);
    if (begins) ui.typed = ui.session.knobs()[part.index].current[part.component];
    if (begins) ImGui::SetKeyboardFocusHere();
    ImGui::InputDouble("##entry", &ui.typed, 0, 0, "%.9g",
                       ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CharsScientific);
    markPart(ui, part);
    // The value changes when the user has finished typing, not with each digit.
    if (!ImGui::IsItemDeactivated()) return;
    setPart(ui, part, ui.typed);
    ui.typing.clear();
}

/// ImGui's integers have 32 bits.
int shownInteger(double value) {
    return static_cast<int>(std::clamp(value, -2147483648.0, 2147483647.0));
}

void slider(Ui& ui, const Part& part) {
    const Knob& knob = ui.session.knobs()[part.index];
    if (!ui.typing.empty() && ui.typing == nameOf(knob, part.component)) return entry(ui, part);
    double value = knob.current[part.component];
    bool changed = false;
    if (!knob.words.empty()) {
        int word = shownInteger(value);
        std::string items;  // ended by zero bytes
        for (const std::string& each : knob.words) items += each + '\0';
        changed = ImGui::Combo("##slider", &word, items.c_str());
        value = word;
    } else if (knob.isInteger()) {
        int integer = shownInteger(value);
        changed = ImGui::SliderInt("##slider", &integer, static_cast<int>(std::ceil(knob.minimum)),
                                   static_cast<int>(std::floor(knob.maximum)));
        value = integer;
    } else {
        changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &knob.minimum, &knob.maximum,
                                      kNumberFormat);
    }
    markPart(ui, part);
    if (!knob.words.empty()) {
        if (changed) setPart(ui, part, value);
        return;
    }
    const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (ImGui::IsItemActivated() && !isSecondClick) ui.valuesBeforeClick = knob.current;
    if (ImGui::IsItemHovered() && isSecondClick) {
        // The first click of the two has moved the slider.
        ui.typing = nameOf(knob, part.component);
        ui.typingBegins = true;
        ui.session.setValue(part.index, ui.valuesBeforeClick);
    } else if (changed) {
        setPart(ui, part, value);
    }
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
    if (changed) setPart(ui, part, value);
}

/// The components of a vector side by side; columns of a matrix and elements of an array in rows.
void components(Ui& ui, std::size_t index) {
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
            slider(ui, {index, i});
        else
            number(ui, {index, i});
        ImGui::PopID();
    }
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
    const ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_PickerHueWheel |
                                      ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_HDR;
    ImGui::SetNextItemWidth(-1);
    const bool changed = count == 4
                             ? ImGui::ColorEdit4("##color", rgba.data(), flags | ImGuiColorEditFlags_AlphaBar)
                             : ImGui::ColorEdit3("##color", rgba.data(), flags);
    mark(ui, "uniform/{}/{}", knob.title, knob.tag);
    if (!changed) return;
    std::vector<double> values(count);
    // The widget shows three digits, so the value is rounded to them.
    std::transform(rgba.begin(), rgba.begin() + static_cast<std::ptrdiff_t>(count), values.begin(),
                   [](float each) { return std::round(static_cast<double>(each) * 1000) / 1000; });
    ui.session.setValue(index, std::move(values));
}

void contextMenu(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    if (!ImGui::BeginPopupContextItem("menu")) return;
    ImGui::TextDisabled("%s", knob.declaration.c_str());
    if (ImGui::MenuItem("Reset", nullptr, false, knob.isChanged())) ui.session.resetValue(index);
    if (ImGui::MenuItem("Copy for the Program line")) ImGui::SetClipboardText(pairText(knob).c_str());
    if (ImGui::MenuItem("Copy as argument (--set)"))
        ImGui::SetClipboardText(
            ("--set " + setArgument(ui.session.live().scene(), knob, ui.session.knobs())).c_str());
    ImGui::EndPopup();
}

void row(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    ImGui::PushID(static_cast<int>(index));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::Selectable(knob.tag.c_str(), false, ImGuiSelectableFlags_AllowItemOverlap);
    mark(ui, "label/{}/{}", knob.title, knob.tag);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s:%d\nRight click: reset or copy", knob.declaration.c_str(),
                          knob.place.file.c_str(), knob.place.line);
    contextMenu(ui, index);
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
            components(ui, index);
            break;
    }
    ImGui::TableNextColumn();
    if (ui.session.knobs()[index].isChanged()) {
        if (ImGui::SmallButton("reset")) ui.session.resetValue(index);
        mark(ui, "reset/{}/{}", knob.title, knob.tag);
    }
    ImGui::PopID();
}

void section(Ui& ui, scene::ProgramIndex program) {
    const std::vector<Knob>& knobs = ui.session.knobs();
    if (!ImGui::BeginTable("values", 3, ImGuiTableFlags_None)) return;
    float widest = 0;
    for (const Knob& each : knobs)
        if (each.program == program) widest = std::max(widest, ImGui::CalcTextSize(each.tag.c_str()).x);
    ImGui::TableSetupColumn("tag", ImGuiTableColumnFlags_WidthFixed,
                            std::min(widest, ImGui::GetContentRegionAvail().x * .4F));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("reset").x + 8);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (knobs[i].program == program) row(ui, i);
    ImGui::EndTable();
    if (ImGui::SmallButton(program ? "Copy Program line" : "Copy Let lines"))
        ImGui::SetClipboardText(programLine(ui.session.live().scene(), program, knobs).c_str());
    mark(ui, "copy/{}", program ? std::to_string(program.position()) : "variables");
}

}  // namespace

void uniformsPanel(Ui& ui) {
    if (!ImGui::CollapsingHeader("Uniforms", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const std::vector<Knob>& knobs = ui.session.knobs();
    if (knobs.empty()) {
        ImGui::TextDisabled("No Program line sets a uniform.");
        return;
    }
    if (ImGui::Button("Reset all")) ui.session.resetValues();
    mark(ui, "uniforms/reset");
    ImGui::SameLine();
    if (ImGui::Button("Copy values")) ImGui::SetClipboardText(setArguments(ui.session).c_str());
    mark(ui, "uniforms/copyValues");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Copy the changed values as arguments for `glibra render`: --set NAME=VALUE ...");
    ImGui::SameLine();
    if (ImGui::Button("Save values")) {
        const Diagnostics problems = saveValues(ui.session.path(), ui.session.knobs());
        ui.notice = problems.empty() ? "saved the values in " + ui.session.path().filename().string()
                                     : toString(problems.front());
    }
    mark(ui, "scene/save");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Write the current values into the Program lines of the .glib file");
    ImGui::SameLine();
    ImGui::Checkbox("Labels", &ui.showLabels);
    mark(ui, "uniforms/labels");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show the values over the picture (L)");
    std::optional<scene::ProgramIndex> drawn;
    for (const Knob& first : knobs) {
        const scene::ProgramIndex last = first.program;
        if (last == drawn) continue;
        drawn = last;
        ImGui::PushID(last ? static_cast<int>(last.position()) : -1);
        const char* state = last && ui.session.live().showsEarlierProgram(last) ? " (last good version)" : "";
        ImGui::SetNextItemOpen(true, ImGuiCond_Once);
        if (ImGui::TreeNodeEx("program", ImGuiTreeNodeFlags_SpanAvailWidth, "%s%s", first.title.c_str(),
                              state)) {
            mark(ui, "section/{}", first.title);
            section(ui, last);
            ImGui::TreePop();
        } else {
            mark(ui, "section/{}", first.title);
        }
        ImGui::PopID();
    }
}

}  // namespace glibra::view
