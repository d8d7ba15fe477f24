#include "view/window/panels/color_field.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>

#include "view/window/panels/number_field.h"

namespace glibra::view {

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
