// The mouse over the picture, and what is drawn over it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "render/draw/view_matrices.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr float kClickPixels = 4;
constexpr float kWheelPixels = 20;

bool isInPicture(const Ui& ui, const ImVec2& at) {
    const Rectangle& r = ui.picture;
    return at.x >= r[0] && at.y >= r[1] && at.x < r[0] + r[2] && at.y < r[1] + r[3];
}

Drag dragOf(const Ui& ui, Gesture gesture, float x, float y) {
    return {gesture, {x, -y}, {ui.picture[2], ui.picture[3]}};
}

Gesture gestureOf(int button, bool shift) {
    if (button == ImGuiMouseButton_Middle) return Gesture::scale;
    if (button == ImGuiMouseButton_Right || shift) return Gesture::pan;
    return Gesture::rotate;
}

/// Projects a point of eye space to screen coordinates. Returns false if it is behind the eye.
bool project(const Ui& ui, const glm::dmat4& projection, const glm::dvec3& eye, ImVec2& screen) {
    const glm::dvec4 clip = projection * glm::dvec4(eye, 1);
    if (clip.w <= 0) return false;
    screen.x = ui.picture[0] + static_cast<float>((clip.x / clip.w + 1) / 2) * ui.picture[2];
    screen.y = ui.picture[1] + static_cast<float>((1 - clip.y / clip.w) / 2) * ui.picture[3];
    return std::isfinite(screen.x) && std::isfinite(screen.y);
}

/// Draws the 3D cursor: lines along the axes of the picked object, through the clicked point.
void cursor(const Ui& ui, ImDrawList& list) {
    const Picked& picked = *ui.session.picked();
    const scene::Draw* draw = nullptr;
    for (const scene::Pass& pass : ui.session.live().scene().frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* each = std::get_if<scene::Draw>(&step))
                if (pass.isWindow && each->id == picked.draw) draw = each;
    if (!draw) return;
    const render::ViewMatrices& view = ui.session.live().view();
    const glm::dmat4 projection = view.projection(draw->projection, ui.picture[2] / ui.picture[3]);
    const glm::dmat4 modelView = view.modelView(*draw);
    const glm::dvec3 point(modelView * glm::dvec4(picked.point, 1));
    ImVec2 centre;
    if (!project(ui, projection, point, centre)) return;
    constexpr std::array<ImU32, 3> kColors{IM_COL32(255, 90, 80, 255), IM_COL32(90, 230, 90, 255),
                                           IM_COL32(90, 150, 255, 255)};
    const double w = std::abs((projection * glm::dvec4(point, 1)).w);
    const double reach = .12 * w / std::max(1e-12, std::abs(projection[1][1]));
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction(modelView[axis]);
        const double length = glm::length(direction);
        if (length == 0) continue;
        ImVec2 from;
        ImVec2 to;
        if (project(ui, projection, point - direction * (reach / length), from) &&
            project(ui, projection, point + direction * (reach / length), to))
            list.AddLine(from, to, kColors[static_cast<std::size_t>(axis)], 2 * ui.scale);
    }
    constexpr int kMostShown = 200;
    const std::string line = sourceLine({ui.session.path().string(), picked.draw.line, 1});
    const std::string text = fmt::format("line {}: {}", picked.draw.line, excerpt(line, 1, kMostShown).text);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at(centre.x + 12 * ui.scale, centre.y + 12 * ui.scale);
    list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + size.x + 4, at.y + size.y + 2}, IM_COL32(0, 0, 0, 170),
                       3);
    list.AddText(at, IM_COL32_WHITE, text.c_str());
}

void labels(const Ui& ui, ImDrawList& list) {
    const float line = ImGui::GetTextLineHeight();
    ImVec2 at(ui.picture[0] + 8, ui.picture[1] + 8);
    for (const Knob& each : ui.session.knobs()) {
        std::string text = each.tag + " ";
        for (std::size_t i = 0; i < std::min<std::size_t>(each.current.size(), 4); ++i)
            text += fmt::format(" {:.4g}", each.current[i]);
        list.AddText({at.x + 1, at.y + 1}, IM_COL32(0, 0, 0, 220), text.c_str());
        list.AddText(at, IM_COL32_WHITE, text.c_str());
        at.y += line;
        if (at.y > ui.picture[1] + ui.picture[3] - line) break;
    }
}

void errorLine(const Ui& ui, ImDrawList& list) {
    for (const Diagnostic& each : ui.session.diagnostics()) {
        if (each.severity != Severity::error) continue;
        const std::string text = toString(each);
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const float top = ui.picture[1] + ui.picture[3] - size.y - 8;
        list.AddRectFilled({ui.picture[0], top}, {ui.picture[0] + ui.picture[2], top + size.y + 8},
                           IM_COL32(140, 20, 20, 220));
        list.PushClipRect({ui.picture[0], top}, {ui.picture[0] + ui.picture[2] - 4, top + size.y + 8});
        list.AddText({ui.picture[0] + 6, top + 4}, IM_COL32_WHITE, text.c_str());
        list.PopClipRect();
        return;
    }
}

}  // namespace

void pictureInput(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool isOver = !io.WantCaptureMouse && isInPicture(ui, io.MousePos);
    if (isOver || ui.dragButton == ImGuiMouseButton_Left)
        ui.session.setMouse(std::clamp((io.MousePos.x - ui.picture[0]) / ui.picture[2], 0.F, 1.F),
                            std::clamp(1 - (io.MousePos.y - ui.picture[1]) / ui.picture[3], 0.F, 1.F),
                            ImGui::IsMouseDown(ImGuiMouseButton_Left));
    bool begins = false;
    if (ui.dragButton < 0 && isOver) {
        for (int button = 0; button < 3; ++button)
            if (ImGui::IsMouseClicked(button)) {
                ui.dragButton = button;
                ui.dragLength = 0;
                begins = true;
            }
        if (io.MouseWheel != 0)
            ui.session.drag(ui.mode, dragOf(ui, Gesture::scale, 0, -io.MouseWheel * kWheelPixels));
    }
    if (ui.dragButton < 0) return;
    if (ImGui::IsMouseDown(ui.dragButton)) {
        // In slow scenes, the mouse's way to the first point arrives in the same frame as the click.
        if (begins) return;
        if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
        ui.dragLength += std::hypot(io.MouseDelta.x, io.MouseDelta.y);
        ui.session.drag(ui.mode,
                        dragOf(ui, gestureOf(ui.dragButton, io.KeyShift), io.MouseDelta.x, io.MouseDelta.y));
        return;
    }
    if (ui.dragButton == ImGuiMouseButton_Left && ui.dragLength < kClickPixels) {
        const double perUnit = ui.session.width() / static_cast<double>(ui.picture[2]);
        ui.session.pickAt(static_cast<int>((io.MousePos.x - ui.picture[0]) * perUnit),
                          static_cast<int>((io.MousePos.y - ui.picture[1]) * perUnit));
    }
    ui.dragButton = -1;
}

void pictureOverlay(Ui& ui) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({ui.picture[0], ui.picture[1]},
                      {ui.picture[0] + ui.picture[2], ui.picture[1] + ui.picture[3]});
    if (ui.session.hasScene()) {
        if (ui.showLabels) labels(ui, list);
        if (ui.session.picked() && ui.session.picture()) cursor(ui, list);
    } else {
        const char* text = "Drop a .glib file here, press Ctrl+O to open one, or X for examples";
        const ImVec2 size = ImGui::CalcTextSize(text);
        list.AddText({ui.picture[0] + (ui.picture[2] - size.x) / 2, ui.picture[1] + ui.picture[3] / 2},
                     IM_COL32(200, 200, 200, 255), text);
    }
    errorLine(ui, list);
    list.PopClipRect();
}

}  // namespace glibra::view
