// The section with a widget for each uniform that the Program lines set.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "glib/text.h"
#include "render/live/knobs.h"
#include "view/export/hardcopy.h"
#include "view/scene/slider_scale.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

// Rows of a table of values: the name of a uniform or variable, its widgets, and buttons that animate and
// reset it.

constexpr int kMostInRow = 4;

/// Large numbers are shown whole: 20000, not 2e+04.
const char* numberFormat(double value) {
    constexpr double kLarge = 1e4, kHuge = 1e8;
    return std::abs(value) >= kLarge && std::abs(value) < kHuge ? "%.0f" : "%.4g";
}

/// A knob as a row shows it: of its program, or for all programs that share it.
struct Row {
    const render::Knob& knob;
    std::size_t index = 0;
    bool isShared = false;
    [[nodiscard]] const char* owner() const { return isShared ? "shared" : knob.title.c_str(); }
};

/// A component of a knob.
struct Part {
    Row row;
    std::size_t component = 0;
    [[nodiscard]] const render::Knob& knob() const { return row.knob; }
    [[nodiscard]] double value() const { return row.knob.current[component]; }
};

/// The widget's name for `--state` and Sliders::typing.
std::string widgetName(const Row& row) {
    return fmt::format("uniform/{}/{}", row.owner(), row.knob.tag);
}
std::string widgetName(const Part& part) {
    const std::string name = widgetName(part.row);
    return part.knob().current.size() == 1 ? name : fmt::format("{}/{}", name, part.component);
}

void markPart(Ui& ui, const Part& part) {
    tabStop(ui);
    if (ui.shared.marksWidgets) markPlace(ui, widgetName(part));
}

void setPart(SceneValues& values, const Part& part, double value) {
    std::vector<double> changed = part.knob().current;
    changed[part.component] = value;
    values.set(part.row.index, std::move(changed));
}

/// A text field in place of the slider, for any value, also beyond the range.
void valueEntry(Ui& ui, const Part& part) {
    double value = part.value();
    const bool isTyped = sliderEntry(ui, "##slider", value);
    markPart(ui, part);
    if (isTyped) setPart(ui.values, part, value);
}

/// ImGui's integers have 32 bits.
int shownInteger(double value) {
    return static_cast<int>(std::clamp(value, -2147483648.0, 2147483647.0));
}

/// A menu of the words of a choice.
void wordMenu(Ui& ui, const Part& part) {
    int word = shownInteger(part.value());
    std::string items;  // ended by zero bytes
    for (const std::string& each : part.knob().words) items += each + '\0';
    const bool isChanged = ImGui::Combo("##slider", &word, items.c_str());
    markPart(ui, part);
    if (isChanged) setPart(ui.values, part, word);
}

/// Returns true if the user wants the menu of the value.
bool slider(Ui& ui, const Part& part) {
    const render::Knob& knob = part.knob();
    if (!knob.words.empty()) {
        wordMenu(ui, part);
        return false;
    }
    if (!ui.sliders.typing.empty() && ui.sliders.typing == widgetName(part)) {
        valueEntry(ui, part);
        return false;
    }
    double value = part.value();
    const SliderUse use = valueSlider(ui, "##slider", scaleOf(knob), value);
    markPart(ui, part);
    const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (use.isActivated && !isSecondClick) ui.sliders.valuesBeforeClick = knob.current;
    if (use.isActivated || use.isChanged) ui.values.animate(part.row.index, false);
    if (use.isTyped) {
        ui.sliders.typing = widgetName(part);
        ui.sliders.typingBegins = true;
        // The first click of the two has moved the slider.
        if (isSecondClick) {
            ui.values.set(part.row.index, ui.sliders.valuesBeforeClick);
            ui.history.takeBack(ui.session);
        }
    } else if (use.isChanged) {
        setPart(ui.values, part, value);
    }
    return use.wantsMenu;
}

void number(Ui& ui, const Part& part) {
    const render::Knob& knob = part.knob();
    double value = part.value();
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
    if (changed) setPart(ui.values, part, value);
}

/// The components of a vector side by side; columns of a matrix and elements of an array in rows. Returns
/// true if the user wants the menu of the value.
bool components(Ui& ui, const Row& row) {
    bool wantsMenu = false;
    const render::Knob& knob = row.knob;
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
    const render::Knob& knob = row.knob;
    bool on = knob.current.front() != 0;
    if (checkBox("##on", &on))
        ui.values.set(row.index, std::vector<double>(knob.current.size(), on ? 1.0 : 0.0));
    mark(ui, "uniform/{}/{}", row.owner(), knob.tag);
}

void color(Ui& ui, const Row& row) {
    const render::Knob& knob = row.knob;
    std::array<float, 4> rgba{0, 0, 0, 1};
    const std::size_t count = std::min<std::size_t>(rgba.size(), knob.current.size());
    std::copy_n(knob.current.begin(), count, rgba.begin());
    if (!colorField(ui, widgetName(row), rgba, count == 4)) return;
    std::vector<double> values(count);
    // The widget shows three digits, so the value is rounded to them.
    std::transform(rgba.begin(), rgba.begin() + static_cast<std::ptrdiff_t>(count), values.begin(),
                   [](float each) { return std::round(static_cast<double>(each) * 1000) / 1000; });
    ui.values.set(row.index, std::move(values));
}

void contextMenu(Ui& ui, const Row& row) {
    const render::Knob& knob = row.knob;
    if (!ImGui::BeginPopup("menu")) return;
    ImGui::TextDisabled("%s", knob.declaration.c_str());
    if (canAnimate(knob)) {
        const bool isMoving = ui.values.isAnimated(row.index);
        if (ImGui::MenuItem("Animate", nullptr, isMoving)) ui.values.animate(row.index, !isMoving);
        mark(ui, "menu/animate");
    }
    if (ImGui::MenuItem("Reset", nullptr, false, knob.isChanged())) ui.values.reset(row.index);
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
            ("--set " + setArgument(ui.session.live().scene(), knob, ui.values.knobs())).c_str());
    ImGui::EndPopup();
}

/// The buttons after the value: animate, and back to the scene's value.
void knobButtons(Ui& ui, const Row& row) {
    const render::Knob& knob = row.knob;
    const float side = ImGui::GetFrameHeight();
    if (canAnimate(knob)) {
        const bool isMoving = ui.values.isAnimated(row.index);
        const bool isPressed = iconButton(
            isMoving ? Icon::pause : Icon::play, "animate",
            isMoving ? "Stop at this value" : "Animate: move between the ends of the range", isMoving);
        if (ui.shared.marksWidgets) markPlace(ui, fmt::format("animate/{}/{}", row.owner(), knob.tag));
        if (isPressed) ui.values.animate(row.index, !isMoving);
    } else {
        ImGui::Dummy({side, side});
    }
    if (!knob.isChanged()) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool isPressed = iconButton(Icon::undo, "reset", "Back to the value of the scene");
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("reset/{}/{}", row.owner(), knob.tag));
    if (isPressed) ui.values.reset(row.index);
}

/// The name, with an ellipsis in its middle if it is too long, and the menu. Returns true if the user wants
/// it.
bool knobName(Ui& ui, const Row& row) {
    const render::Knob& knob = row.knob;
    const float width = ImGui::GetContentRegionAvail().x;
    const bool fits = ImGui::CalcTextSize(knob.tag.c_str()).x <= width;
    ImGui::AlignTextToFramePadding();
    ImGui::Selectable(fits ? knob.tag.c_str() : shortened(knob.tag, width).c_str(), false,
                      ImGuiSelectableFlags_AllowItemOverlap);
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("label/{}/{}", row.owner(), knob.tag));
    const bool wantsMenu = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    if (!ImGui::IsItemHovered()) return wantsMenu;
    ui.frame.hoverText = knob.declaration;
    std::string owners;
    if (row.isShared)
        for (const render::Knob& each : ui.values.knobs())
            if (each.tag == knob.tag && each.initial == knob.initial) owners += " " + each.title;
    ImGui::SetTooltip("%s\n%s:%d\n%s%s%sRight click: animate, reset, label or copy", knob.declaration.c_str(),
                      knob.place.file.c_str(), knob.place.line, owners.empty() ? "" : "in", owners.c_str(),
                      owners.empty() ? "" : "\n");
    return wantsMenu;
}

void rowOf(Ui& ui, const Row& row) {
    const render::Knob& knob = row.knob;
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
    contextMenu(ui, row);
    ImGui::TableNextColumn();
    knobButtons(ui, row);
    ImGui::PopID();
}

/// One row for knobs that programs share, at least one: that of the first. What is done to it is done to all.
void sharedRow(Ui& ui, const std::vector<std::size_t>& members) {
    const std::size_t first = members.front();
    const render::Knob& knob = ui.values.knobs()[first];
    const std::vector<double> before = knob.current;
    const bool wasAnimated = ui.values.isAnimated(first);
    rowOf(ui, {knob, first, true});
    const bool isAnimated = ui.values.isAnimated(first);
    for (const std::size_t each : std::span(members).subspan(1)) {
        if (knob.current != before) ui.values.set(each, knob.current);
        if (isAnimated != wasAnimated) ui.values.animate(each, isAnimated);
    }
}

/// Begins the table of rows whose widest name takes `widest` units of the screen. False: it is not visible;
/// otherwise the caller ends it by ImGui::EndTable().
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

/// Rows of the knobs for which `isShown` is true.
template <class IsShown>
void rows(Ui& ui, const IsShown& isShown) {
    const std::vector<render::Knob>& knobs = ui.values.knobs();
    float widest = 0;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (isShown(i)) widest = std::max(widest, ImGui::CalcTextSize(knobs[i].tag.c_str()).x);
    if (widest == 0 || !beginRows(widest)) return;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (isShown(i)) rowOf(ui, {knobs[i], i, false});
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
        const std::vector<render::Knob>& knobs = ui.values.knobs();
        if (knobs.empty()) return withoutValues(ui);
        if (std::exchange(loaded_, ui.session.timesLoaded()) != ui.session.timesLoaded()) {
            shared_ = sharedKnobs(knobs);
            isShared_.assign(knobs.size(), false);
            for (const auto& group : shared_)
                for (const std::size_t each : group) isShared_[each] = true;
        }
        if (button(ui, "Reset all", "uniforms/reset")) ui.values.resetAll();
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
        if (ui.values.knobs().size() < kMany) {
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
        const std::vector<render::Knob>& knobs = ui.values.knobs();
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
        const std::vector<render::Knob>& knobs = ui.values.knobs();
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
        const std::vector<render::Knob>& knobs = ui.values.knobs();
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
        const std::vector<render::Knob>& knobs = ui.values.knobs();
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
     [](Ui& ui, Panel&) { ui.values.resetAll(); }},
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
