#include "view/window/panels/value_fields.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "view/window/panels/shortcuts.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr double kStep = .01, kPage = .1;  // of the scale
constexpr double kFine = .1;

using Text = std::array<char, 48>;

/// "0.25", with four digits; integers with all of theirs.
const char* writeValue(Text& text, double value, const SliderScale& scale, const char* unit) {
    const auto end = scale.isInteger
                         ? fmt::format_to_n(text.data(), text.size() - 1, "{:.0f}{}", value, unit).out
                         : fmt::format_to_n(text.data(), text.size() - 1, "{:.4g}{}", value + 0.0, unit).out;
    *end = 0;
    return text.data();
}

struct Track {
    ImVec2 low, high;
    float thumb = 0;  ///< width
    [[nodiscard]] float length() const { return std::max(1.F, high.x - low.x - thumb); }
    [[nodiscard]] float centreAt(double position) const {
        return low.x + thumb / 2 + static_cast<float>(position) * length();
    }
    [[nodiscard]] double positionAt(float x) const { return (x - low.x - thumb / 2) / length(); }
};

/// Follows the mouse. A click on the thumb moves nothing, a click beside it brings the thumb to the mouse.
void dragThumb(Ui& ui, const Track& track, const SliderScale& scale, bool begins, double& value) {
    const ImGuiIO& io = ImGui::GetIO();
    SliderDrag& drag = ui.sliders.drag;
    const auto moved = [&] {
        return (io.MousePos.x - drag.mouse) / track.length() * (drag.isFine ? kFine : 1);
    };
    if (begins) {
        const double now = scale.positionOf(value);
        const bool isOnThumb = std::abs(io.MousePos.x - track.centreAt(now)) <= track.thumb;
        const double from = isOnThumb || io.KeyShift ? now : track.positionAt(io.MousePos.x);
        drag = {io.MousePos.x, from, io.KeyShift};
        if (isOnThumb || io.KeyShift) return;
    } else if (io.KeyShift != drag.isFine) {
        drag.position = std::clamp(drag.position + moved(), 0.0, 1.0);
        drag.mouse = io.MousePos.x;
        drag.isFine = io.KeyShift;
        return;
    } else if (io.MouseDelta.x == 0) {
        return;
    }
    value = scale.valueAt(drag.position + moved(), drag.isFine);
}

void drawTexts(const Track& track, const SliderScale& scale, double value, double position,
               const char* unit) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemInnerSpacing.x;
    Text text;
    writeValue(text, value, scale, unit);
    const ImVec2 size = ImGui::CalcTextSize(text.data());
    const float thumbLeft = track.centreAt(position) - track.thumb / 2;
    const float thumbRight = thumbLeft + track.thumb;
    // Beside the thumb, where there is more room; never beyond the track.
    const bool isRight = track.high.x - thumbRight >= thumbLeft - track.low.x;
    const float wanted = isRight ? thumbRight + gap : thumbLeft - gap - size.x;
    const float left =
        std::clamp(wanted, track.low.x + gap, std::max(track.low.x + gap, track.high.x - gap - size.x));
    const float top = track.low.y + (track.high.y - track.low.y - size.y) / 2;
    ImFont* small = smallFont();
    const float smallSize = small->FontSize * ImGui::GetIO().FontGlobalScale;
    const auto end = [&](double bound, bool isHigh) {
        Text boundText;
        writeValue(boundText, bound, scale, "");
        const ImVec2 boundSize = small->CalcTextSizeA(smallSize, 1e9F, 0, boundText.data());
        const float x = isHigh ? track.high.x - gap - boundSize.x : track.low.x + gap;
        const auto touches = [&](float from, float to) {
            return x < to + gap && from - gap < x + boundSize.x;
        };
        if (touches(left, left + size.x) || touches(thumbLeft, thumbRight)) return;
        const bool isOnFill = !isHigh;
        list.AddText(small, smallSize, {x, track.low.y + (track.high.y - track.low.y - boundSize.y) / 2},
                     ImGui::GetColorU32(isOnFill ? ImGuiCol_Text : ImGuiCol_TextDisabled), boundText.data());
    };
    end(scale.minimum, false);
    end(scale.maximum, true);
    list.AddText({left, top}, ImGui::GetColorU32(ImGuiCol_Text), text.data());
}

void drawTrack(const Ui& ui, const Track& track, const SliderScale& scale, double value, const char* unit,
               bool isFocused) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    const int background = ImGui::IsItemActive()    ? ImGuiCol_FrameBgActive
                           : ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered
                                                    : ImGuiCol_FrameBg;
    const double position = scale.positionOf(value);
    const float centre = track.centreAt(position);
    list.AddRectFilled(track.low, track.high, ImGui::GetColorU32(background), style.FrameRounding);
    list.AddRectFilled(track.low, {centre, track.high.y}, ImGui::GetColorU32(ImGuiCol_PlotHistogram),
                       style.FrameRounding, ImDrawFlags_RoundCornersLeft);
    if (style.FrameBorderSize > 0)
        list.AddRect(track.low, track.high, ImGui::GetColorU32(ImGuiCol_Border), style.FrameRounding, 0,
                     style.FrameBorderSize);
    list.AddRectFilled({centre - track.thumb / 2, track.low.y}, {centre + track.thumb / 2, track.high.y},
                       ImGui::GetColorU32(ImGuiCol_SliderGrab), track.thumb / 2);
    list.PushClipRect(track.low, track.high, true);
    drawTexts(track, scale, value, position, unit);
    list.PopClipRect();
    if (isFocused)
        list.AddRect(track.low, track.high, ImGui::GetColorU32(ImGuiCol_NavHighlight), style.FrameRounding, 0,
                     2 * ui.shared.scale);
}

void takeKeys(Ui& ui, const SliderScale& scale, double& value) {
    if (const auto end = std::exchange(ui.sliders.end, std::nullopt)) value = scale.valueAt(*end ? 1 : 0);
    if (const double moves = std::exchange(ui.sliders.moves, 0); moves != 0)
        value = scale.moved(value, moves, ImGui::GetIO().KeyShift);
}

}  // namespace

SliderUse valueSlider(Ui& ui, const char* id, const SliderScale& scale, double& value, const char* unit) {
    const float thumb = std::round(1.5F * kSpace * ui.shared.scale);
    const ImVec2 size(std::max(4 * thumb, ImGui::CalcItemWidth()), ImGui::GetFrameHeight());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size);
    const Track track{low, {low.x + size.x, low.y + size.y}, thumb};
    const unsigned itemId = ImGui::GetID(id);
    const bool isDisabled = (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
    if (!isDisabled) ui.sliders.drawn.push_back({itemId, thisWindow(), true, false});
    const double before = value;
    SliderUse use;
    use.isActivated = ImGui::IsItemActivated();
    use.wantsMenu = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    const bool wantsByKey = ui.sliders.focused == itemId && std::exchange(ui.sliders.wantsMenu, false);
    use.isTyped = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (use.isActivated || use.wantsMenu) {
        ui.sliders.focused = itemId;
        ui.sliders.wasClicked = true;
    }
    use.wantsMenu = use.wantsMenu || wantsByKey;
    const bool isFocused = ui.sliders.focused == itemId;
    if (ImGui::IsItemActive() && !use.isTyped) {
        dragThumb(ui, track, scale, use.isActivated, value);
    } else if (isFocused) {
        if (std::exchange(ui.sliders.reveals, false) && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        takeKeys(ui, scale, value);
        use.isTyped = use.isTyped || std::exchange(ui.sliders.isTyped, false);
    }
    use.isChanged = value != before;
    drawTrack(ui, track, scale, value, unit, isFocused);
    return use;
}

bool sliderEntry(Ui& ui, const char* id, double& value) {
    if (std::exchange(ui.sliders.typingBegins, false)) {
        ui.sliders.typedBefore = fmt::format("{:.9g}", value);
        setField(ui.sliders.typed, ui.sliders.typedBefore);
        giveKeyboardToNext();
    }
    // Keeps the keyboard for the slider that comes back.
    ui.sliders.drawn.push_back({ImGui::GetID(id), thisWindow(), true, false});
    ImGui::InputText("##entry", ui.sliders.typed.data(), ui.sliders.typed.size(),
                     ImGuiInputTextFlags_AutoSelectAll);
    // The value changes when the user has finished typing, not with each digit.
    if (!ImGui::IsItemDeactivated()) return false;
    ui.sliders.typing.clear();
    const std::string_view text = ui.sliders.typed.data();
    if (text == ui.sliders.typedBefore) return false;
    const std::optional<double> number = typedNumber(text);
    if (number)
        value = *number;
    else
        ui.notice = {
            fmt::format("'{}' is no number that a slider can have; they are like .5, 1/3 or 2*sqrt(3)", text),
            true};
    return number.has_value();
}

bool labelledSlider(Ui& ui, const char* label, std::string_view name, const SliderScale& scale, double& value,
                    const char* unit) {
    ImGui::PushID(label);
    const double before = value;
    if (!ui.sliders.typing.empty() && ui.sliders.typing == name) {
        if (sliderEntry(ui, "##slider", value)) {
            value = std::clamp(value, scale.minimum, scale.maximum);
            if (scale.isInteger) value = std::round(value);
        }
    } else {
        const SliderUse use = valueSlider(ui, "##slider", scale, value, unit);
        const bool isSecondClick = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        if (use.isActivated && !isSecondClick) ui.sliders.valuesBeforeClick = {before};
        if (use.isTyped) {
            ui.sliders.typing = name;
            ui.sliders.typingBegins = true;
            // The first click of the two has moved the slider.
            if (isSecondClick && ui.sliders.valuesBeforeClick.size() == 1)
                value = ui.sliders.valuesBeforeClick.front();
        }
    }
    mark(ui, name);
    ImGui::PopID();
    if (std::string_view(label).starts_with("##")) return value != before;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    return value != before;
}

void beginSliders(Ui& ui) {
    ui.sliders.moves = 0;
    ui.sliders.end.reset();
    ui.sliders.isTyped = ui.sliders.wasClicked = false;
    const ImGuiIO& io = ImGui::GetIO();
    const bool isElsewhere = ui.shared.question || !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    const unsigned before = ui.sliders.focused;
    beginStops(ui);
    const bool isValue = std::ranges::any_of(ui.sliders.drawn, [&](const TabStop& each) {
        return each.isValue && each.id == before && before == ui.sliders.focused;
    });
    if (isValue && !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && !isElsewhere) {
        const double fine = io.KeyShift ? kFine : 1;
        const auto move = [&](int key, const char* name, double by) {
            if (!isUsedByScene(ui, name) && isKeyPressed(key)) ui.sliders.moves += by * fine;
        };
        move(GLFW_KEY_RIGHT, "right", kStep);
        move(GLFW_KEY_UP, "up", kStep);
        move(GLFW_KEY_LEFT, "left", -kStep);
        move(GLFW_KEY_DOWN, "down", -kStep);
        move(GLFW_KEY_PAGE_UP, "pageup", kPage);
        move(GLFW_KEY_PAGE_DOWN, "pagedown", -kPage);
        if (isKeyPressed(GLFW_KEY_HOME)) ui.sliders.end = false;
        if (isKeyPressed(GLFW_KEY_END)) ui.sliders.end = true;
        ui.sliders.isTyped = isEnterPressed(false) && !isUsedByScene(ui, "enter");
    }
    ui.sliders.drawn.clear();
}

void endSliders(Ui& ui) {
    const bool isGone = std::ranges::none_of(
        ui.sliders.drawn, [&](const TabStop& each) { return each.id == ui.sliders.focused; });
    if (isGone && ui.sliders.typing.empty() && ImGui::GetCurrentContext()->OpenPopupStack.empty())
        ui.sliders.focused = 0;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ui.sliders.wasClicked) ui.sliders.focused = 0;
}

std::optional<bool> typedInto(Ui& ui, const char* label, double& value) {
    const ImGuiID id = ImGui::GetID(label);
    const ImGuiInputTextState* state = ImGui::GetInputTextState(id);
    if (!ImGui::TempInputIsActive(id) || state == nullptr) return std::nullopt;
    Sliders& typing = ui.sliders;
    if (std::exchange(typing.typedField, id) != id) {
        typing.typedBefore = state->TextA.Data;
        typing.valueBefore = value;
        setField(typing.typed, typing.typedBefore);
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImRect frame(at, {at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(frame, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)) return false;
    const bool isEdited =
        ImGui::TempInputText(frame, id, label, typing.typed.data(), static_cast<int>(typing.typed.size()),
                             ImGuiInputTextFlags_None);
    if (!ImGui::TempInputIsActive(id)) typing.typedField = 0;
    if (!isEdited) return false;
    const double before = value;
    // Esc brings the first text back, which may have fewer digits than the value.
    if (typing.typedBefore == typing.typed.data())
        value = typing.valueBefore;
    else if (const std::optional<double> number = typedNumber(typing.typed.data()))
        value = *number;
    return value != before;
}

bool numberEntry(const char* label, double& value, const char* format, int flags) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    if (!ImGui::InputText(label, text.data(), text.size(), flags)) return false;
    const std::optional<double> number = typedNumber(text.data());
    if (!number || *number == value) return false;
    value = *number;
    return true;
}

bool wholeEntry(const char* label, int& value, int least, int most, int flags) {
    double number = value;
    if (!numberEntry(label, number, "%.0f", flags)) return false;
    const auto whole = static_cast<int>(
        std::clamp(std::round(number), static_cast<double>(least), static_cast<double>(most)));
    return std::exchange(value, whole) != whole;
}

bool pairEntry(Ui& ui, const char* label, std::array<double, 2>& values, const char* format) {
    const float space = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::CalcItemWidth() - space) / 2);
    bool isChanged = false;
    ImGui::BeginGroup();
    ImGui::PushID(label);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, space);
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(width);
        isChanged = numberEntry("##number", values.at(i), format) || isChanged;
        tabStop(ui);
        ImGui::PopID();
    }
    ImGui::PopID();
    if (const char* end = ImGui::FindRenderedTextEnd(label); end != label) {
        ImGui::SameLine(0, space);
        ImGui::TextUnformatted(label, end);
    }
    ImGui::EndGroup();
    return isChanged;
}

bool sidesEntry(Ui& ui, const char* label, int& width, int& height, int most) {
    std::array<double, 2> sides{static_cast<double>(width), static_cast<double>(height)};
    if (!pairEntry(ui, label, sides, "%.0f")) return false;
    const auto whole = [most](double side) {
        return static_cast<int>(std::clamp(std::round(side), 1., static_cast<double>(most)));
    };
    width = whole(sides[0]);
    height = whole(sides[1]);
    return true;
}

bool colorSwatch(Ui& ui, const char* id, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha) {
    ImGui::PushID(id);
    const ImGuiColorEditFlags alpha =
        hasAlpha ? ImGuiColorEditFlags_AlphaPreviewHalf : ImGuiColorEditFlags_NoAlpha;
    if (ImGui::ColorButton("##swatch", {rgba[0], rgba[1], rgba[2], rgba[3]}, alpha))
        ImGui::OpenPopup("picker");
    mark(ui, name);
    bool isChanged = false;
    if (ImGui::BeginPopup("picker")) {
        ImGui::SetNextItemWidth(220 * ui.shared.scale);
        constexpr ImGuiColorEditFlags kFlags = ImGuiColorEditFlags_Float |
                                               ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_HDR |
                                               ImGuiColorEditFlags_NoSidePreview;
        isChanged = hasAlpha
                        ? ImGui::ColorPicker4("##picker", rgba.data(), kFlags | ImGuiColorEditFlags_AlphaBar)
                        : ImGui::ColorPicker3("##picker", rgba.data(), kFlags);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return isChanged;
}

bool colorField(Ui& ui, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha) {
    const int count = hasAlpha ? 4 : 3;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float space = style.ItemInnerSpacing.x;
    const float least = ImGui::CalcTextSize("0.000").x + 4;
    const float all = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - space;
    const auto widthOfEach = [&](int inRow) {
        return (all - space * static_cast<float>(inRow - 1)) / static_cast<float>(inRow);
    };
    int inRow = count;
    while (inRow > 1 && widthOfEach(inRow) < least) inRow = (inRow + 1) / 2;
    bool isChanged = colorSwatch(
        ui, "swatch", ui.shared.marksWidgets ? std::string(name) + "/swatch" : std::string(), rgba, hasAlpha);
    ImGui::SameLine(0, space);
    ImGui::BeginGroup();
    // The padding would take the room of a digit.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(1, style.FramePadding.y));
    for (int i = 0; i < count; ++i) {
        if (i % inRow != 0) ImGui::SameLine(0, space);
        ImGui::SetNextItemWidth(std::max(20.F, widthOfEach(inRow)));
        ImGui::PushID(i);
        float& component = rgba[static_cast<std::size_t>(i)];
        double typed = component;
        if (const std::optional<bool> isTyped = typedInto(ui, "##component", typed)) {
            if (*isTyped) component = static_cast<float>(typed);
            isChanged = *isTyped || isChanged;
        } else {
            isChanged = ImGui::DragFloat("##component", &component, .004F, 0, 0, "%.3f") || isChanged;
        }
        tabStop(ui);
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    ImGui::EndGroup();
    markPlace(ui, name);
    return isChanged;
}

}  // namespace glibra::view
