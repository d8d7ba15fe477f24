#include "view/window/panels/icons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

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

}  // namespace

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
