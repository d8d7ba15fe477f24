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
    const auto found = std::find_if(ui.panels.begin(), ui.panels.end(),
                                    [&](const PanelUse& each) { return each.row->name == name; });
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

bool lineOfText(const char* text, const ImVec2& at, float right) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    // Underscores may stand a little below the height of the text.
    const float below = std::ceil(ImGui::GetFontSize() * .2F);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {right, at.y + size.y + below}, right, right,
                              text, nullptr, &size);
    return at.x + size.x <= right;
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

}  // namespace glibra::view
