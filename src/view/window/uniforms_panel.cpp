// The panel made from the Program lines.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "view/hardcopy.h"
#include "view/save_values.h"
#include "view/window/ui.h"

namespace glibra::view {
namespace {

constexpr int kMostInRow = 4;
constexpr const char* kNumberFormat = "%.4g";

std::string nameOf(const Knob& knob) {
    return "uniform/" + knob.title + "/" + knob.tag;
}

/// An entry field for any value, also beyond the range, in place of the slider.
void entry(Ui& ui, std::size_t index, std::size_t component, const std::string& name) {
    const bool begins = std::exchange(ui.typingBegins, false);
    if (begins) ui.typed = ui.session.knobs()[index].current[component];
    if (begins) ImGui::SetKeyboardFocusHere();
    ImGui::InputDouble(("##entry/" + name).c_str(), &ui.typed, 0, 0, "%.9g",
                       ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CharsScientific);
    mark(ui, name);
    // The value changes when the entry is complete, not with each digit.
    if (!ImGui::IsItemDeactivated()) return;
    std::vector<double> values = ui.session.knobs()[index].current;
    values[component] = ui.typed;
    ui.session.setValue(index, std::move(values));
    ui.typing.clear();
}

void slider(Ui& ui, std::size_t index, std::size_t component, const std::string& name) {
    if (ui.typing == name) return entry(ui, index, component, name);
    const Knob& knob = ui.session.knobs()[index];
    std::vector<double> values = knob.current;
    bool changed = false;
    if (knob.isInteger()) {
        auto value = static_cast<int>(std::clamp(values[component], -2147483648.0, 2147483647.0));
        changed = ImGui::SliderInt(("##" + name).c_str(), &value, static_cast<int>(std::ceil(knob.minimum)),
                                   static_cast<int>(std::floor(knob.maximum)));
        values[component] = value;
    } else {
        changed = ImGui::SliderScalar(("##" + name).c_str(), ImGuiDataType_Double, &values[component],
                                      &knob.minimum, &knob.maximum, kNumberFormat);
    }
    mark(ui, name);
    const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (ImGui::IsItemActivated() && !isSecondClick) ui.valuesBeforeClick = knob.current;
    if (ImGui::IsItemHovered() && isSecondClick) {
        // The first click of the two has moved the slider.
        ui.session.setValue(index, ui.valuesBeforeClick);
        ui.typing = name;
        ui.typingBegins = true;
    } else if (changed) {
        ui.session.setValue(index, std::move(values));
    }
}

void number(Ui& ui, std::size_t index, std::size_t component, const std::string& name) {
    const Knob& knob = ui.session.knobs()[index];
    std::vector<double> values = knob.current;
    const auto speed =
        static_cast<float>(knob.isInteger() ? .1 : std::max(.002, std::abs(knob.initial[component]) * .005));
    bool changed = false;
    if (knob.isInteger()) {
        auto value = static_cast<int>(std::clamp(values[component], -2147483648.0, 2147483647.0));
        changed = ImGui::DragInt(("##" + name).c_str(), &value, speed);
        values[component] = value;
    } else {
        changed = ImGui::DragScalar(("##" + name).c_str(), ImGuiDataType_Double, &values[component], speed,
                                    nullptr, nullptr, kNumberFormat);
    }
    mark(ui, name);
    if (changed) ui.session.setValue(index, std::move(values));
}

/// The components side by side, a matrix's columns and an array's elements below one another.
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
        const std::string name = count == 1 ? nameOf(knob) : fmt::format("{}/{}", nameOf(knob), i);
        if (knob.widget == Widget::slider)
            slider(ui, index, i, name);
        else
            number(ui, index, i, name);
    }
}

void checkBox(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    bool on = knob.current.front() != 0;
    if (ImGui::Checkbox(("##" + nameOf(knob)).c_str(), &on))
        ui.session.setValue(index, std::vector<double>(knob.current.size(), on ? 1.0 : 0.0));
    mark(ui, nameOf(knob));
}

void color(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    std::array<float, 4> rgba{0, 0, 0, 1};
    const std::size_t count = std::min<std::size_t>(rgba.size(), knob.current.size());
    std::copy_n(knob.current.begin(), count, rgba.begin());
    const ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_PickerHueWheel |
                                      ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_HDR;
    ImGui::SetNextItemWidth(-1);
    const std::string label = "##" + nameOf(knob);
    const bool changed =
        count == 4 ? ImGui::ColorEdit4(label.c_str(), rgba.data(), flags | ImGuiColorEditFlags_AlphaBar)
                   : ImGui::ColorEdit3(label.c_str(), rgba.data(), flags);
    mark(ui, nameOf(knob));
    if (!changed) return;
    std::vector<double> values(count);
    // Shown with three digits, so kept with no more.
    std::transform(rgba.begin(), rgba.begin() + static_cast<std::ptrdiff_t>(count), values.begin(),
                   [](float each) { return std::round(static_cast<double>(each) * 1000) / 1000; });
    ui.session.setValue(index, std::move(values));
}

void contextMenu(Ui& ui, std::size_t index) {
    const Knob& knob = ui.session.knobs()[index];
    if (!ImGui::BeginPopupContextItem(("menu/" + nameOf(knob)).c_str())) return;
    ImGui::TextDisabled("%s", knob.placeOfUniform.c_str());
    if (ImGui::MenuItem("Reset", nullptr, false, knob.isChanged())) ui.session.resetValue(index);
    if (ImGui::MenuItem("Copy as part of the Program line")) ImGui::SetClipboardText(pairText(knob).c_str());
    if (ImGui::MenuItem("Copy as --set argument"))
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
    mark(ui, "label/" + knob.title + "/" + knob.tag);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s:%d\nright click for more", knob.placeOfUniform.c_str(),
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
        mark(ui, "reset/" + knob.title + "/" + knob.tag);
    }
    ImGui::PopID();
}

void section(Ui& ui, int program) {
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
    if (ImGui::SmallButton("Copy Program line"))
        ImGui::SetClipboardText(programLine(ui.session.live().scene(), program, knobs).c_str());
    mark(ui, fmt::format("copy/{}", program));
}

}  // namespace

void uniformsPanel(Ui& ui) {
    if (!ImGui::CollapsingHeader("Uniforms", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const std::vector<Knob>& knobs = ui.session.knobs();
    if (knobs.empty()) {
        ImGui::TextDisabled("The Program lines set none.");
        return;
    }
    if (ImGui::Button("Reset all")) ui.session.resetValues();
    mark(ui, "uniforms/reset");
    ImGui::SameLine();
    if (ImGui::Button("Copy --set")) ImGui::SetClipboardText(setArguments(ui.session).c_str());
    mark(ui, "uniforms/copySet");
    ImGui::SameLine();
    if (ImGui::Button("Save values")) {
        const Diagnostics problems = saveValues(ui.session.path(), ui.session.knobs());
        ui.notice = problems.empty() ? "values saved into " + ui.session.path().filename().string()
                                     : toString(problems.front());
    }
    mark(ui, "scene/save");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Puts the present values into the Program lines of the .glib file");
    ImGui::SameLine();
    ImGui::Checkbox("Labels", &ui.showLabels);
    mark(ui, "uniforms/labels");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Shows the values over the picture (L)");
    int last = -1;
    for (const Knob& first : knobs) {
        if (first.program == last) continue;
        last = first.program;
        ImGui::PushID(last);
        const std::string title =
            first.title +
            (ui.session.live().showsEarlierProgram(last) ? " (last good version)###program" : "###program");
        ImGui::SetNextItemOpen(true, ImGuiCond_Once);
        if (ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth)) {
            mark(ui, "section/" + first.title);
            section(ui, last);
            ImGui::TreePop();
        } else {
            mark(ui, "section/" + first.title);
        }
        ImGui::PopID();
    }
}

}  // namespace glibra::view
