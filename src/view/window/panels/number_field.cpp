#include "view/window/panels/number_field.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cstdio>

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

bool numberEntry(const char* label, double& value, const char* format) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    if (!ImGui::InputText(label, text.data(), text.size())) return false;
    const std::optional<double> number = typedNumber(text.data());
    if (!number || *number == value) return false;
    value = *number;
    return true;
}

}  // namespace glibra::view
