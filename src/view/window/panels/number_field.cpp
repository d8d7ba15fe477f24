#include "view/window/panels/number_field.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "view/scene/typed_number.h"

namespace glibra::view {

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

}  // namespace glibra::view
