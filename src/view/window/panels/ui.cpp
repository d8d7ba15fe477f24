#include "view/window/panels/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// Stores whether a section is open, if that is not as at first.
void remember(Ui& ui, std::string_view name, bool isOpen, bool isOpenAtFirst) {
    auto& folds = ui.settings.folds;
    const auto known = folds.find(name);
    if (isOpen == isOpenAtFirst) {
        if (known != folds.end()) folds.erase(known);
    } else {
        folds.insert_or_assign(std::string(name), isOpen);
    }
}

bool wasOpen(const Ui& ui, std::string_view name, bool isOpenAtFirst) {
    const auto known = ui.settings.folds.find(name);
    return known == ui.settings.folds.end() ? isOpenAtFirst : known->second;
}

}  // namespace

Panel& toolWindow(const Ui& ui, std::string_view name) {
    const auto found =
        std::ranges::find_if(ui.panels, [&](const PanelUse& each) { return each.row->name == name; });
    assert(found != ui.panels.end());
    return *found->panel;
}

void toggleOpen(Ui& /*ui*/, Panel& panel) {
    panel.isOpen = !panel.isOpen;
}

void mark(Ui& ui, std::string_view name) {
    tabStop(ui);
    markPlace(ui, name);
}

void markPlace(Ui& ui, std::string_view name) {
    if (!ui.shared.marksWidgets || !ImGui::IsItemVisible()) return;
    // In menus and lists the arrow keys choose.
    const bool isInPopup = !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    if (isInPopup ? ImGui::IsItemFocused()
                  : ui.sliders.focused != 0 && ImGui::GetItemID() == ui.sliders.focused)
        ui.frame.focusedName = name;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    ui.frame.widgets[std::string(name)] = {low.x, low.y, size.x, size.y};
}

void markField(Ui& ui, std::string_view name, std::string_view label) {
    mark(ui, name);
    const auto made = ui.frame.widgets.find(std::string(name));
    if (made == ui.frame.widgets.end()) return;
    const float width = ImGui::CalcTextSize(label.data(), label.data() + label.size(), true).x;
    if (width > 0) made->second[2] -= width + ImGui::GetStyle().ItemInnerSpacing.x;
}

void markWindow(Ui& ui, std::string_view name) {
    if (!ui.shared.marksWidgets) return;
    const ImVec2 at = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ui.frame.widgets[std::string(name)] = {at.x, at.y, size.x, size.y};
}

bool button(Ui& ui, const char* label, std::string_view name, const char* help) {
    const bool isPressed = ImGui::Button(label);
    mark(ui, name);
    tooltip(help);
    return isPressed;
}

bool smallButton(Ui& ui, const char* label, std::string_view name, const char* help) {
    const bool isPressed = ImGui::SmallButton(label);
    mark(ui, name);
    tooltip(help);
    return isPressed;
}

bool beginCombo(Ui& ui, const char* id, const char* shown, std::string_view name, ImGuiComboFlags flags) {
    const bool isOpen = ImGui::BeginCombo(id, shown, flags);
    mark(ui, name);
    return isOpen;
}

void tooltip(const char* text, ImGuiHoveredFlags flags) {
    if (text != nullptr && ImGui::IsItemHovered(flags)) ImGui::SetTooltip("%s", text);
}

void wrappedTooltip(const char* text, float width) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool section(Ui& ui, const char* title, std::string_view name, bool isOpenAtFirst) {
    const bool before = wasOpen(ui, name, isOpenAtFirst);
    ImGui::SetNextItemOpen(before);
    ImGui::PushFont(headingFont());
    const bool isOpen = ImGui::CollapsingHeader(title);
    ImGui::PopFont();
    mark(ui, name);
    if (isOpen != before) remember(ui, name, isOpen, isOpenAtFirst);
    return isOpen;
}

bool group(Ui& ui, const char* title, std::string_view name) {
    const bool before = wasOpen(ui, name, true);
    ImGui::SetNextItemOpen(before);
    const bool isOpen =
        ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    mark(ui, name);
    if (isOpen != before) remember(ui, name, isOpen, true);
    return isOpen;
}

void fieldLabel(const char* label) {
    const float column = ImGui::CalcTextSize("Background").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(left + column);
    ImGui::SetNextItemWidth(-1);
}

namespace {

class Outlined {
  public:
    Outlined() {
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
        ImGui::PushStyleColor(ImGuiCol_Border, asVector(palette().outline));
    }
    Outlined(const Outlined&) = delete;
    Outlined& operator=(const Outlined&) = delete;
    ~Outlined() {
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
    }
};

}  // namespace

bool checkBox(const char* label, bool* isOn) {
    const Outlined outlined;
    return ImGui::Checkbox(label, isOn);
}
bool checkBox(Ui& ui, const char* label, std::string_view name, bool& isOn, const char* help) {
    const bool isChanged = checkBox(label, &isOn);
    mark(ui, name);
    tooltip(help);
    return isChanged;
}
bool radioButton(const char* label, bool isOn) {
    const Outlined outlined;
    return ImGui::RadioButton(label, isOn);
}

void wordBefore(const char* word) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(word);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
}

void besideIfRoom(float width) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

std::string shortened(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const auto isInside = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    for (std::size_t kept = text.size(); kept > 2; --kept) {
        std::size_t left = (kept + 1) / 2, right = text.size() - kept / 2;
        while (left > 1 && left < text.size() && isInside(left)) --left;
        while (right < text.size() && isInside(right)) ++right;
        std::string made = text.substr(0, left) + ".." + text.substr(right);
        if (ImGui::CalcTextSize(made.c_str()).x <= width) return made;
    }
    return text.substr(0, 1);
}

void lineOfText(const char* text, const ImVec2& at, float right, ImU32 color) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    // Underscores may stand a little below the height of the text.
    const float below = std::ceil(ImGui::GetFontSize() * .2F);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {right, at.y + size.y + below}, right, right,
                              text, nullptr, &size);
    ImGui::PopStyleColor();
}

void wrappedText(const Color& color, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, asVector(color));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

void codeText(const std::string& text) {
    ImGui::PushFont(codeFont());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
}

void colorSquare(std::span<const double> numbers) {
    const float side = ImGui::GetTextLineHeight();
    const auto part = [&](std::size_t i) {
        return i < numbers.size() ? static_cast<float>(std::clamp(numbers[i], 0.0, 1.0)) : 0.F;
    };
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              ImGui::ColorConvertFloat4ToU32({part(0), part(1), part(2), 1}));
    ImGui::Dummy({side, side});
    ImGui::SameLine();
}

void ring(const Ui& ui, ImDrawList& list, const ImVec2& middle, float radius) {
    list.AddCircle(middle, radius, IM_COL32_BLACK, 0, 3 * ui.shared.scale);
    list.AddCircle(middle, radius, IM_COL32_WHITE, 0, 1.5F * ui.shared.scale);
}

void centreNextWindow(ImGuiCond when) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, when, {.5F, .5F});
}

bool beginModal(const char* title) {
    centreNextWindow(ImGuiCond_Always);
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
}

EditedFile* knownSource(const Ui& ui, const std::filesystem::path& file) {
    const auto found = ui.shared.sources.find(file);
    return found == ui.shared.sources.end() ? nullptr : &found->second;
}

void placeFloating(const Ui& ui, float left, float top, float width, float height) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(width * ui.shared.scale, screen.x),
                      std::min(height * ui.shared.scale, screen.y));
    ImGui::SetNextWindowSizeConstraints(
        {std::min(240 * ui.shared.scale, screen.x), std::min(160 * ui.shared.scale, screen.y)}, screen);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowPos({std::min(left * ui.shared.scale, screen.x - size.x),
                             std::min(top * ui.shared.scale, screen.y - size.y)},
                            ImGuiCond_FirstUseEver);
}

void showSource(Ui& ui, const Place& place) {
    ui.settings.showSource = true;
    ui.wanted.source = place;
}

void openDialog(Ui& ui, bool inNewTab) {
    ui.wanted.file = FileRequest{std::nullopt, inNewTab, {}};
}

void askForFile(Ui& ui, FileQuestion question, std::filesystem::path folder) {
    ui.wanted.file = FileRequest{std::move(question), false, std::move(folder)};
}

}  // namespace glibra::view
