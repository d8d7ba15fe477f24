#include "view/window/panels/uniform_rows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "view/export/hardcopy.h"
#include "view/scene/slider_scale.h"
#include "view/window/panels/color_field.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/label_overlay.h"
#include "view/window/panels/number_field.h"
#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr int kMostInRow = 4;

/// Large numbers are shown whole: 20000, not 2e+04.
const char* numberFormat(double value) {
    constexpr double kLarge = 1e4, kHuge = 1e8;
    return std::abs(value) >= kLarge && std::abs(value) < kHuge ? "%.0f" : "%.4g";
}

/// A knob as a row shows it: of its program, or for all programs that share it.
struct Row {
    std::size_t index = 0;
    bool isShared = false;
};

/// A component of a knob.
struct Part {
    Row row;
    std::size_t component = 0;
    [[nodiscard]] std::size_t index() const { return row.index; }
};

const char* ownerOf(const render::Knob& knob, const Row& row) {
    return row.isShared ? "shared" : knob.title.c_str();
}

/// The widget's name for `--state` and Sliders::typing.
std::string widgetName(const render::Knob& knob, const Row& row) {
    return fmt::format("uniform/{}/{}", ownerOf(knob, row), knob.tag);
}
std::string widgetName(const Ui& ui, const Part& part) {
    const render::Knob& knob = ui.session.knobs()[part.index()];
    const std::string name = widgetName(knob, part.row);
    return knob.current.size() == 1 ? name : fmt::format("{}/{}", name, part.component);
}

void markPart(Ui& ui, const Part& part) {
    tabStop(ui);
    if (ui.shared.marksWidgets) markPlace(ui, widgetName(ui, part));
}

void setPart(Ui& ui, const Part& part, double value) {
    std::vector<double> values = ui.session.knobs()[part.index()].current;
    values[part.component] = value;
    ui.session.setValue(part.index(), std::move(values));
}

/// A text field in place of the slider, for any value, also beyond the range.
void valueEntry(Ui& ui, const Part& part) {
    double value = ui.session.knobs()[part.index()].current[part.component];
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
    const render::Knob& knob = ui.session.knobs()[part.index()];
    int word = shownInteger(knob.current[part.component]);
    std::string items;  // ended by zero bytes
    for (const std::string& each : knob.words) items += each + '\0';
    const bool isChanged = ImGui::Combo("##slider", &word, items.c_str());
    markPart(ui, part);
    if (isChanged) setPart(ui, part, word);
}

/// Returns true if the user wants the menu of the value.
bool slider(Ui& ui, const Part& part) {
    const render::Knob& knob = ui.session.knobs()[part.index()];
    if (!knob.words.empty()) {
        wordMenu(ui, part);
        return false;
    }
    if (!ui.sliders.typing.empty() && ui.sliders.typing == widgetName(ui, part)) {
        valueEntry(ui, part);
        return false;
    }
    double value = knob.current[part.component];
    const SliderUse use = valueSlider(ui, "##slider", scaleOf(knob), value);
    markPart(ui, part);
    const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (use.isActivated && !isSecondClick) ui.sliders.valuesBeforeClick = knob.current;
    if (use.isActivated || use.isChanged) ui.session.animate(part.index(), false);
    if (use.isTyped) {
        ui.sliders.typing = widgetName(ui, part);
        ui.sliders.typingBegins = true;
        // The first click of the two has moved the slider.
        if (isSecondClick) {
            ui.session.setValue(part.index(), ui.sliders.valuesBeforeClick);
            ui.history.takeBack(ui.session);
        }
    } else if (use.isChanged) {
        setPart(ui, part, value);
    }
    return use.wantsMenu;
}

void number(Ui& ui, const Part& part) {
    const render::Knob& knob = ui.session.knobs()[part.index()];
    double value = knob.current[part.component];
    const auto speed = static_cast<float>(
        knob.isInteger() ? .1 : std::max(.002, std::abs(knob.initial[part.component]) * .005));
    bool changed = false;
    if (const std::optional<bool> typed = typedInto(ui, "##number", value)) {
        changed = *typed;
    } else if (knob.isInteger()) {
        int integer = shownInteger(value);
        changed = ImGui::DragInt("##number", &integer, speed);
        value = integer;
    } else {
        changed = ImGui::DragScalar("##number", ImGuiDataType_Double, &value, speed, nullptr, nullptr,
                                    numberFormat(value));
    }
    markPart(ui, part);
    if (changed && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        value = withoutLeftover(value, static_cast<double>(speed));
    if (changed) setPart(ui, part, value);
}

/// The components of a vector side by side; columns of a matrix and elements of an array in rows. Returns
/// true if the user wants the menu of the value.
bool components(Ui& ui, const Row& row) {
    bool wantsMenu = false;
    const render::Knob& knob = ui.session.knobs()[row.index];
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
        if (knob.widget == render::Widget::slider)
            wantsMenu = slider(ui, {row, i}) || wantsMenu;
        else
            number(ui, {row, i});
        ImGui::PopID();
    }
    return wantsMenu;
}

void booleanRow(Ui& ui, const Row& row) {
    const render::Knob& knob = ui.session.knobs()[row.index];
    bool on = knob.current.front() != 0;
    if (checkBox("##on", &on))
        ui.session.setValue(row.index, std::vector<double>(knob.current.size(), on ? 1.0 : 0.0));
    mark(ui, "uniform/{}/{}", ownerOf(knob, row), knob.tag);
}

void color(Ui& ui, const Row& row) {
    const render::Knob& knob = ui.session.knobs()[row.index];
    std::array<float, 4> rgba{0, 0, 0, 1};
    const std::size_t count = std::min<std::size_t>(rgba.size(), knob.current.size());
    std::copy_n(knob.current.begin(), count, rgba.begin());
    const bool changed = colorField(ui, widgetName(knob, row), rgba, count == 4);
    if (!changed) return;
    std::vector<double> values(count);
    // The widget shows three digits, so the value is rounded to them.
    std::transform(rgba.begin(), rgba.begin() + static_cast<std::ptrdiff_t>(count), values.begin(),
                   [](float each) { return std::round(static_cast<double>(each) * 1000) / 1000; });
    ui.session.setValue(row.index, std::move(values));
}

/// Animations move between the ends of a range.
bool canMove(const render::Knob& knob) {
    return knob.widget == render::Widget::slider && knob.words.empty();
}

void contextMenu(Ui& ui, std::size_t index) {
    const render::Knob& knob = ui.session.knobs()[index];
    if (!ImGui::BeginPopup("menu")) return;
    ImGui::TextDisabled("%s", knob.declaration.c_str());
    if (canMove(knob)) {
        const bool isMoving = ui.session.isAnimated(index);
        if (ImGui::MenuItem("Animate", nullptr, isMoving)) ui.session.animate(index, !isMoving);
        mark(ui, "menu/animate");
    }
    if (ImGui::MenuItem("Reset", nullptr, false, knob.isChanged())) ui.session.resetValue(index);
    mark(ui, "menu/reset");
    bool isLabelled = ui.labelled.contains(labelKey(knob));
    if (ImGui::MenuItem("Label on the picture", nullptr, &isLabelled)) {
        if (isLabelled)
            ui.labelled.insert(labelKey(knob));
        else
            ui.labelled.erase(labelKey(knob));
        ui.settings.labelChoice = LabelChoice::chosen;
        ui.shared.showLabels = true;
    }
    mark(ui, "menu/label");
    if (ImGui::MenuItem("Copy for the Program line")) ImGui::SetClipboardText(pairText(knob).c_str());
    if (ImGui::MenuItem("Copy as argument (--set)"))
        ImGui::SetClipboardText(
            ("--set " + setArgument(ui.session.live().scene(), knob, ui.session.knobs())).c_str());
    ImGui::EndPopup();
}

/// The buttons after the value: animate, and back to the scene's value.
void knobButtons(Ui& ui, const Row& row) {
    const std::size_t index = row.index;
    const render::Knob& knob = ui.session.knobs()[index];
    const float side = ImGui::GetFrameHeight();
    if (canMove(knob)) {
        const bool isMoving = ui.session.isAnimated(index);
        const bool isPressed = iconButton(
            isMoving ? Icon::pause : Icon::play, "animate",
            isMoving ? "Stop at this value" : "Animate: move between the ends of the range", isMoving);
        if (ui.shared.marksWidgets) markPlace(ui, fmt::format("animate/{}/{}", ownerOf(knob, row), knob.tag));
        if (isPressed) ui.session.animate(index, !isMoving);
    } else {
        ImGui::Dummy({side, side});
    }
    if (!knob.isChanged()) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool isPressed = iconButton(Icon::undo, "reset", "Back to the value of the scene");
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("reset/{}/{}", ownerOf(knob, row), knob.tag));
    if (isPressed) ui.session.resetValue(index);
}

/// The name, with an ellipsis in its middle if it is too long, and the menu. Returns true if the user wants
/// it.
bool knobName(Ui& ui, const Row& row) {
    const render::Knob& knob = ui.session.knobs()[row.index];
    const float width = ImGui::GetContentRegionAvail().x;
    const bool fits = ImGui::CalcTextSize(knob.tag.c_str()).x <= width;
    ImGui::AlignTextToFramePadding();
    ImGui::Selectable(fits ? knob.tag.c_str() : shortened(knob.tag, width).c_str(), false,
                      ImGuiSelectableFlags_AllowItemOverlap);
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("label/{}/{}", ownerOf(knob, row), knob.tag));
    const bool wantsMenu = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    if (!ImGui::IsItemHovered()) return wantsMenu;
    ui.frame.hoverText = knob.declaration;
    std::string owners;
    if (row.isShared)
        for (const render::Knob& each : ui.session.knobs())
            if (each.tag == knob.tag && each.initial == knob.initial) owners += " " + each.title;
    ImGui::SetTooltip("%s\n%s:%d\n%s%s%sRight click: animate, reset, label or copy", knob.declaration.c_str(),
                      knob.place.file.c_str(), knob.place.line, owners.empty() ? "" : "in", owners.c_str(),
                      owners.empty() ? "" : "\n");
    return wantsMenu;
}

void rowOf(Ui& ui, const Row& row) {
    const render::Knob& knob = ui.session.knobs()[row.index];
    ImGui::PushID(static_cast<int>(row.index));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool wantsMenu = knobName(ui, row);
    ImGui::TableNextColumn();
    const std::size_t stopsBefore = ui.sliders.drawn.size();
    switch (knob.widget) {
        case render::Widget::checkBox:
            booleanRow(ui, row);
            break;
        case render::Widget::color:
            color(ui, row);
            break;
        case render::Widget::slider:
        case render::Widget::numbers:
            wantsMenu = components(ui, row) || wantsMenu;
            break;
    }
    // The menu key, if a widget of the row has the keyboard.
    const auto begin = ui.sliders.drawn.begin() + static_cast<std::ptrdiff_t>(stopsBefore);
    std::for_each(begin, ui.sliders.drawn.end(), [](TabStop& each) { each.isInValues = true; });
    if (ui.sliders.wantsMenu && std::any_of(begin, ui.sliders.drawn.end(), [&](const TabStop& each) {
            return each.id == ui.sliders.focused;
        }))
        wantsMenu = true;
    if (wantsMenu) ImGui::OpenPopup("menu");
    contextMenu(ui, row.index);
    ImGui::TableNextColumn();
    knobButtons(ui, row);
    ImGui::PopID();
}

}  // namespace

void knobRow(Ui& ui, std::size_t index) {
    rowOf(ui, {index, false});
}

void sharedRow(Ui& ui, const std::vector<std::size_t>& members) {
    const std::size_t first = members.front();
    const std::vector<double> before = ui.session.knobs()[first].current;
    const bool wasAnimated = ui.session.isAnimated(first);
    rowOf(ui, {first, true});
    const bool isAnimated = ui.session.isAnimated(first);
    const std::vector<double> now = ui.session.knobs()[first].current;
    for (const std::size_t each : std::span(members).subspan(1)) {
        if (now != before) ui.session.setValue(each, now);
        if (isAnimated != wasAnimated) ui.session.animate(each, isAnimated);
    }
}

bool beginRows(float widest) {
    if (!ImGui::BeginTable("values", 3, ImGuiTableFlags_None)) return false;
    constexpr float kMostForNames = .36F;
    ImGui::TableSetupColumn("tag", ImGuiTableColumnFlags_WidthFixed,
                            std::min(widest, ImGui::GetContentRegionAvail().x * kMostForNames));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("buttons", ImGuiTableColumnFlags_WidthFixed,
                            2 * ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    return true;
}

}  // namespace glibra::view
