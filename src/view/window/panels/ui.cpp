#include "view/window/panels/ui.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

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

/// Draws in a square from (-1, -1), top left, to (1, 1).
class Pen {
  public:
    Pen(ImDrawList& list, const ImVec2& at, float side, ImU32 color)
        : list_(list), centre_{at.x + side / 2, at.y + side / 2}, half_(side / 2), color_(color) {}

    void line(float x, float y, float toX, float toY) {
        list_.AddLine(point(x, y), point(toX, toY), color_, width());
    }
    void rectangle(float left, float top, float right, float bottom) {
        list_.AddRect(point(left, top), point(right, bottom), color_, half_ * .12F, 0, width());
    }
    void bar(float left, float top, float right, float bottom) {
        list_.AddRectFilled(point(left, top), point(right, bottom), color_);
    }
    void triangle(float x, float top, float bottom, float tip) {
        list_.AddTriangleFilled(point(x, top), point(x, bottom), point(tip, (top + bottom) / 2), color_);
    }
    /// An arc from one angle to another, in turns clockwise from the right, with an arrow at its end.
    void turn(float radius, float from, float to) {
        constexpr float kTurn = 2 * std::numbers::pi_v<float>;
        constexpr int kSegments = 20;
        list_.PathArcTo(centre_, radius * half_, from * kTurn, to * kTurn, kSegments);
        list_.PathStroke(color_, 0, width());
        const float direction = to > from ? 1.F : -1.F;
        const float x = radius * std::cos(to * kTurn);
        const float y = radius * std::sin(to * kTurn);
        const float alongX = -std::sin(to * kTurn) * direction * .55F;
        const float alongY = std::cos(to * kTurn) * direction * .55F;
        list_.AddTriangleFilled(point(x + alongX, y + alongY), point(x - alongY * .8F, y + alongX * .8F),
                                point(x + alongY * .8F, y - alongX * .8F), color_);
    }

  private:
    [[nodiscard]] ImVec2 point(float x, float y) const {
        return {centre_.x + x * half_, centre_.y + y * half_};
    }
    [[nodiscard]] float width() const { return std::max(1.F, half_ * .2F); }

    ImDrawList& list_;
    ImVec2 centre_;
    float half_;
    ImU32 color_;
};

float textWidth(const char* label) {
    return ImGui::CalcTextSize(label, nullptr, true).x;
}

float toolWidth(const char* word, bool isShort) {
    const ImGuiStyle& style = ImGui::GetStyle();
    if (isShort) return ImGui::GetFrameHeight();
    return ImGui::GetFontSize() + style.ItemInnerSpacing.x + textWidth(word) + 2 * style.FramePadding.x;
}

/// Draws the icon into a square.
void drawIcon(ImDrawList& list, Icon icon, const ImVec2& at, float side, ImU32 color) {
    Pen pen(list, at, side, color);
    switch (icon) {
        case Icon::open:
            pen.rectangle(-.9F, -.4F, .9F, .75F);
            pen.bar(-.9F, -.75F, -.05F, -.35F);
            return;
        case Icon::examples:
            for (const float x : {-.85F, .15F})
                for (const float y : {-.85F, .15F}) pen.bar(x, y, x + .7F, y + .7F);
            return;
        case Icon::source:
            pen.line(-.4F, -.6F, -.95F, 0);
            pen.line(-.95F, 0, -.4F, .6F);
            pen.line(.4F, -.6F, .95F, 0);
            pen.line(.95F, 0, .4F, .6F);
            pen.line(.2F, -.8F, -.2F, .8F);
            return;
        case Icon::reload:
            pen.turn(.7F, -.1F, .72F);
            return;
        case Icon::help: {
            const ImVec2 size = ImGui::CalcTextSize("?");
            list.AddText({at.x + (side - size.x) / 2, at.y + (side - size.y) / 2}, color, "?");
            return;
        }
        case Icon::play:
            pen.triangle(-.6F, -.8F, .8F, .85F);
            return;
        case Icon::pause:
            pen.bar(-.65F, -.8F, -.15F, .8F);
            pen.bar(.15F, -.8F, .65F, .8F);
            return;
        case Icon::back:
            pen.triangle(.3F, -.75F, .75F, -.8F);
            pen.bar(.55F, -.75F, .8F, .75F);
            return;
        case Icon::forward:
            pen.triangle(-.3F, -.75F, .75F, .8F);
            pen.bar(-.8F, -.75F, -.55F, .75F);
            return;
        case Icon::restart:
            pen.triangle(.8F, -.75F, .75F, -.35F);
            pen.bar(-.8F, -.75F, -.5F, .75F);
            return;
        case Icon::step:
            pen.triangle(-.8F, -.75F, .75F, .35F);
            pen.bar(.5F, -.75F, .8F, .75F);
            return;
        case Icon::undo:
            pen.turn(.65F, .25F, -.5F);
            return;
    }
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

std::span<const PanelRow* const> panelRows() {
    static constexpr std::array kRows{
#define GLIBRA_PANEL(row) &(row),
#include "view/window/panels/panels.def"
#undef GLIBRA_PANEL
    };
    return kRows;
}

PanelSet makePanels(bool areShared) {
    PanelSet panels;
    for (const PanelRow* row : panelRows())
        panels.push_back(row->isShared == areShared ? row->make() : nullptr);
    return panels;
}

std::vector<PanelUse> panelsOf(const PanelSet& shared, const PanelSet& own) {
    std::vector<PanelUse> panels;
    for (std::size_t i = 0; i < panelRows().size(); ++i)
        panels.push_back({panelRows()[i], shared[i] ? shared[i].get() : own[i].get()});
    return panels;
}

bool iconButton(Icon icon, const char* id, const char* help, bool isOn) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(id);
    const bool isPressed = ImGui::Button("##icon", {side, side});
    ImGui::PopID();
    tooltip(help, ImGuiHoveredFlags_AllowWhenDisabled);
    const float inner = std::round(ImGui::GetFontSize() * .85F);
    const float margin = std::round((side - inner) / 2);
    const ImU32 color = isOn ? ImGui::GetColorU32(ImGuiCol_CheckMark) : ImGui::GetColorU32(ImGuiCol_Text);
    drawIcon(*ImGui::GetWindowDrawList(), icon, {at.x + margin, at.y + margin}, inner, color);
    return isPressed;
}

bool toolButton(Icon icon, const char* word, const char* help, bool isShort) {
    if (isShort) return iconButton(icon, word, help != nullptr ? help : word);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float side = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(word);
    const bool isPressed = ImGui::Button("##tool", {toolWidth(word, false), 0});
    ImGui::PopID();
    tooltip(help, ImGuiHoveredFlags_AllowWhenDisabled);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const ImVec2 inside(at.x + style.FramePadding.x, at.y + style.FramePadding.y);
    drawIcon(list, icon, {inside.x, inside.y + side * .08F}, side * .85F, color);
    list.AddText({inside.x + side + style.ItemInnerSpacing.x, inside.y}, color, word);
    return isPressed;
}

void continueRow(float width) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right) ImGui::SameLine();
}

void continueRowForButton(const char* label) {
    continueRow(textWidth(label) + 2 * ImGui::GetStyle().FramePadding.x);
}

void continueRowForCheck(const char* label) {
    continueRow(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + textWidth(label));
}

void continueRowForIcon() {
    continueRow(ImGui::GetFrameHeight());
}

void continueRowForTool(const char* word, bool isShort) {
    continueRow(toolWidth(word, isShort));
}

std::size_t shortTools(std::span<const char* const> words, float width) {
    for (std::size_t count = 0; count < words.size(); ++count) {
        float needed = ImGui::GetStyle().ItemSpacing.x * static_cast<float>(words.size() - 1);
        for (std::size_t i = 0; i < words.size(); ++i) needed += toolWidth(words[i], i < count);
        if (needed <= width) return count;
    }
    return words.size();
}

}  // namespace glibra::view
