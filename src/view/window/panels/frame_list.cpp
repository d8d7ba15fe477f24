// The list of the window "Frame": what the frame executes, with small pictures and times.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "view/session/frame_cost.h"
#include "view/window/panels/frame_window.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

void thumbnail(const FrameWindow& window, std::size_t index, const ImVec2& at, const ImVec2& room) {
    if (index >= window.thumbnails.size() || !window.thumbnails[index]) return;
    const gpu::Texture& texture = *window.thumbnails[index];
    const auto width = static_cast<float>(texture.size().width),
               height = static_cast<float>(texture.size().height);
    const float scale = std::min(room.x / width, room.y / height);
    const ImVec2 from(at.x + (room.x - scale * width) / 2, at.y + (room.y - scale * height) / 2);
    drawTexture(texture, {from.x, from.y, scale * width, scale * height});
}

/// "(29 items)" of a pass whose items are not listed.
std::string foldedWords(const FrameWindow& window, std::size_t pass) {
    std::size_t end = pass + 1;
    while (end < window.items.size() && window.items[end].isInPass()) ++end;
    return fmt::format("({} {})", end - pass - 1, end - pass == 2 ? "item" : "items");
}

void row(Ui& ui, FrameWindow& window, std::size_t index) {
    const FrameItem& item = window.items[index];
    const bool isPass = item.kind == FrameItem::Kind::pass;
    const float height = (isPass || !item.isInPass() ? 44.F : 34.F) * ui.shared.scale;
    const bool isExecuted = index >= window.isDrawn.size() || window.isDrawn[index];
    ImGui::PushID(item.key.c_str());
    const ImVec2 at = ImGui::GetCursorPos();
    const float indent = item.isInPass() ? 14 * ui.shared.scale : 0;
    ImGui::SetCursorPosX(at.x + indent);
    const ImVec2 screen = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##row", item.key == window.chosen, 0, {0, height})) {
        if (isPass && item.key == window.chosen) {
            if (window.isFolded(item.key))
                std::erase(window.folded, item.key);
            else
                window.folded.push_back(item.key);
        }
        window.choose(item);
    }
    mark(ui, "frame/item/{}", item.key);
    if (item.key == window.chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    if (ImGui::IsItemHovered() && !isExecuted)
        ImGui::SetTooltip("nothing of it is drawn: it is out of sight, or its program failed");
    const float wide = height * 1.5F;
    thumbnail(window, index, screen, {wide, height - 2});
    std::string text = labelOf(item);
    if (isPass && window.isFolded(item.key)) text += "  " + foldedWords(window, index);
    const ImU32 color = ImGui::GetColorU32(isExecuted ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    const float left = screen.x + wide + 6 * ui.shared.scale, line = ImGui::GetTextLineHeight();
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const auto time = window.times.milliseconds.find(item.key);
    const bool isTimed = time != window.times.milliseconds.end();
    const float top = screen.y + (height - (isTimed ? 2 : 1) * line) / 2;
    lineOfText(text.c_str(), {left, top}, right, color);
    if (isTimed)
        lineOfText((millisecondsText(time->second, window.times.decimals) + " ms").c_str(),
                   {left, top + line}, right, packed(palette().dim));
    ImGui::PopID();
}

/// Measures the GPU time of each item.
void measureItems(Ui& ui, FrameWindow& window) {
    const FrameCost cost = measureParts(ui.session, ui.context.capabilities());
    window.times = {decimalsOf(cost), cost.isEstimate, {}};
    for (const FrameItem& each : window.items) {
        if (!each.isInPass() && each.node < cost.nodes.size())
            window.times.milliseconds[each.key] = cost.nodes[each.node].milliseconds;
        for (const DrawCost& draw : cost.draws)
            if (each.kind == FrameItem::Kind::draw && draw.step == each.step)
                window.times.milliseconds[each.key] = draw.milliseconds;
    }
}

void timesButton(Ui& ui, FrameWindow& window) {
    const bool isPressed = smallButton(ui, "GPU times", "frame/times",
                                       "Measure how long each pass, dispatch and draw takes now");
    if (isPressed && ui.session.canLookInto()) measureItems(ui, window);
    if (!window.times.isEstimate || window.times.milliseconds.empty()) return;
    ImGui::SameLine();
    ImGui::TextDisabled("estimates");
}

/// The keys up and down choose the item before and after.
void chooseByKeys(FrameWindow& window, const std::vector<std::size_t>& rows) {
    if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) || ImGui::IsAnyItemActive()) return;
    const int step = (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) ? 1 : 0) -
                     (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) ? 1 : 0);
    if (step == 0 || rows.empty()) return;
    const auto found = std::ranges::find(rows, window.index().value_or(rows.front()));
    const auto now = static_cast<int>(found == rows.end() ? 0 : found - rows.begin());
    const int next = std::clamp(now + step, 0, static_cast<int>(rows.size()) - 1);
    window.choose(window.items[rows[static_cast<std::size_t>(next)]]);
}

}  // namespace

std::string labelOf(const FrameItem& item) {
    std::string text = item.number > 0 ? fmt::format("{} {}", item.title, item.number) : item.title;
    if (!item.program.empty() && item.kind == FrameItem::Kind::draw) text += "  " + item.program;
    if (item.place.line > 0) text += fmt::format("  line {}", item.place.line);
    return text;
}

void frameList(Ui& ui, FrameWindow& window) {
    timesButton(ui, window);
    std::vector<std::size_t> rows;
    bool isHidden = false;
    for (std::size_t i = 0; i < window.items.size(); ++i) {
        const FrameItem& each = window.items[i];
        if (!each.isInPass()) isHidden = window.isFolded(each.key);
        if (!each.isInPass() || !isHidden) rows.push_back(i);
    }
    chooseByKeys(window, rows);
    for (const std::size_t each : rows) row(ui, window, each);
}

}  // namespace glibra::view
