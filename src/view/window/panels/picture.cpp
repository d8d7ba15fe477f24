// The mouse over the picture, and what is drawn over it.

#include "view/window/panels/ui.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "image/image.h"
#include "render/draw/axes.h"
#include "render/draw/view_matrices.h"
#include "view/edit/source_lines.h"
#include "view/scene/transforms.h"
#include "view/scene/window_target.h"
#include "view/window/panels/texel_view.h"

namespace glibra::view {
namespace {

struct LabelOverlay {
    std::vector<std::string> lines;  ///< in `texture`
    int scale = 0;
    std::optional<gpu::Texture> texture;
};

/// Draws the block into a texture, unless the texture has it already.
void updateTexture(const gpu::Capabilities& capabilities, const render::LabelBlock& block,
                   LabelOverlay& overlay) {
    if (overlay.texture && overlay.scale == block.scale && overlay.lines == block.lines) return;
    image::Image picture{block.width, block.height, 4, image::Component::u8, {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(picture.height));
    render::drawLabels(picture, block, 0, 0);
    overlay = {block.lines, block.scale,
               textureOfBytes(capabilities, block.width, block.height, picture.data, GL_NEAREST, GL_NEAREST)};
}

/// Finds the values to label; none in `only`: all. Returns false if there are none.
bool hasLabels(const Ui& ui, std::vector<std::string>& only) {
    if (ui.settings.labelChoice == LabelChoice::all) return true;
    const std::vector<render::Knob>& knobs = ui.values.knobs();
    for (const render::Knob& each : knobs)
        if (ui.settings.labelChoice == LabelChoice::changed ? each.isChanged()
                                                            : ui.labelled.contains(labelKey(each)))
            only.push_back(labelBegin(each));
    return !only.empty();
}

/// Draws the values over the picture, if they are wanted.
void labelOverlay(Ui& ui, LabelOverlay& overlay) {
    std::vector<std::string> only;
    const bool isShown = ui.shared.showLabels && ui.session.hasScene() && hasLabels(ui, only);
    ui.look.setLabels(isShown ? ui.settings.labelCorner : LabelCorner::none, only);
    if (!isShown) {
        overlay = {};
        return;
    }
    const render::LabelBlock block = render::labelBlock(
        ui.look.width(), ui.look.height(), ui.session.live().labels(only), ui.settings.labelCorner);
    if (block.lines.empty()) return;
    updateTexture(ui.context.capabilities(), block, overlay);
    if (!overlay.texture) return;
    // The picture is blitted pixel by pixel; so is the block.
    const float pixels = ImGui::GetIO().DisplayFramebufferScale.x;  // per unit of the screen
    ImVec2 at((std::round(ui.frame.picture[0] * pixels) + static_cast<float>(block.left)) / pixels,
              (std::round(ui.frame.picture[1] * pixels) + static_cast<float>(block.top)) / pixels);
    // Beside a source that stands over the picture.
    if (at.x < ui.frame.covered)
        at.x = std::max(at.x, std::min(std::round(ui.frame.covered + 4 * ui.shared.scale),
                                       ui.frame.picture[0] + ui.frame.picture[2] -
                                           static_cast<float>(block.width) / pixels));
    const ImVec2 end(at.x + static_cast<float>(block.width) / pixels,
                     at.y + static_cast<float>(block.height) / pixels);
    ImGui::GetBackgroundDrawList()->AddImage(idOf(*overlay.texture), at, end);
}

constexpr float kClickPixels = 4;
constexpr float kWheelPixels = 20;

/// How the mouse uses the picture.
struct MouseUse {
    Wheel wheel;
    int button = -1;   ///< that drags the picture; -1: none
    float length = 0;  ///< of the drag, pixels so far
};

bool isInPicture(const Ui& ui, const ImVec2& at) {
    const Rectangle& r = ui.frame.picture;
    return at.x >= r[0] && at.y >= r[1] && at.x < r[0] + r[2] && at.y < r[1] + r[3];
}

Drag dragOf(const Ui& ui, Gesture gesture, float x, float y) {
    return {gesture, {x, -y}, {ui.frame.picture[2], ui.frame.picture[3]}};
}

Gesture gestureOf(int button, bool control, bool shift) {
    if (button == ImGuiMouseButton_Middle || control) return Gesture::scale;
    if (button == ImGuiMouseButton_Right || shift) return Gesture::pan;
    return Gesture::rotate;
}

/// Projects a point of eye space to screen coordinates. Returns false if it is behind the eye.
bool project(const Ui& ui, const glm::dmat4& projection, const glm::dvec3& eye, ImVec2& screen) {
    const glm::dvec4 clip = projection * glm::dvec4(eye, 1);
    if (clip.w <= 0) return false;
    screen.x = ui.frame.picture[0] + static_cast<float>((clip.x / clip.w + 1) / 2) * ui.frame.picture[2];
    screen.y = ui.frame.picture[1] + static_cast<float>((1 - clip.y / clip.w) / 2) * ui.frame.picture[3];
    return std::isfinite(screen.x) && std::isfinite(screen.y);
}

/// Draws text on a dark ground.
void label(const Ui& ui, ImDrawList& list, const ImVec2& at, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float x = 4 * ui.shared.scale, y = 2 * ui.shared.scale;
    list.AddRectFilled({at.x - x, at.y - y}, {at.x + size.x + x, at.y + size.y + y}, IM_COL32(0, 0, 0, 170),
                       3);
    list.AddText(at, IM_COL32_WHITE, text.c_str());
}

/// Draws the 3D cursor: lines along the axes of the picked object, through its middle and past its ends.
void cursor(const Ui& ui, ImDrawList& list) {
    const Picked& picked = *ui.look.picked();
    const scene::Draw* draw = nullptr;
    for (const scene::Draw* each : windowDraws(ui.session.live().scene()))
        if (each->id == picked.draw) draw = each;
    if (!draw) return;
    const render::ViewMatrices& view = ui.session.live().view();
    const glm::dmat4 projection =
        view.projection(*draw->projection, ui.frame.picture[2] / ui.frame.picture[3]);
    const glm::dmat4 modelView = view.modelView(*draw);
    const glm::dvec3 middle(modelView * glm::dvec4(picked.centre, 1));
    ImVec2 centre;
    if (!project(ui, projection, middle, centre)) return;
    constexpr std::array<ImU32, 3> kColors{IM_COL32(255, 90, 80, 255), IM_COL32(90, 230, 90, 255),
                                           IM_COL32(90, 150, 255, 255)};
    constexpr double kLeastReach = .12;  // of half the height of the picture
    constexpr double kPastEnd = 1.25;
    const double w = std::abs((projection * glm::dvec4(middle, 1)).w);
    const double least = kLeastReach * w / std::max(1e-12, std::abs(projection[1][1]));
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction(modelView[axis]);
        const double length = glm::length(direction);
        if (length == 0) continue;
        const double reach = std::max(least / length, kPastEnd * picked.half[axis]);
        ImVec2 from;
        ImVec2 to;
        if (!project(ui, projection, middle - direction * reach, from) ||
            !project(ui, projection, middle + direction * reach, to))
            continue;
        list.AddLine(from, to, IM_COL32(0, 0, 0, 150), 4 * ui.shared.scale);
        list.AddLine(from, to, kColors[static_cast<std::size_t>(axis)], 2 * ui.shared.scale);
    }
    constexpr int kMostShown = 200;
    const std::string line = sourceLine({ui.session.path().generic_string(), picked.draw.line, 1});
    // Whole inside the picture, wherever the cursor is.
    const Rectangle& r = ui.frame.picture;
    const float gap = 12 * ui.shared.scale, edge = 6 * ui.shared.scale;
    const std::string text = shortened(
        fmt::format("line {}: {}", picked.draw.line, excerpt(line, 1, kMostShown).text), r[2] - 2 * edge);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    label(ui, list,
          {std::clamp(centre.x + gap, r[0] + edge, std::max(r[0] + edge, r[0] + r[2] - edge - size.x)),
           std::clamp(centre.y + gap, r[1] + edge, std::max(r[1] + edge, r[1] + r[3] - edge - size.y))},
          text);
}

/// The GPU time of the objects of a frame, at the upper right corner.
void frameRate(const Ui& ui, ImDrawList& list) {
    const std::optional<double> milliseconds = ui.session.objectMilliseconds();
    const bool isMeasured = ui.context.capabilities().timerBits > 0;
    if (!milliseconds && isMeasured) return;
    constexpr double kMillisecondsInSecond = 1000;
    // Nothing may be drawn in less time than the clock measures.
    const std::string text = !isMeasured ? "GPU time: not measured"
                             : *milliseconds <= 0
                                 ? "no objects"
                                 : fmt::format("{:.1f} frames/s  {:.2f} ms GPU time",
                                               kMillisecondsInSecond / *milliseconds, *milliseconds);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    label(ui, list,
          {ui.frame.picture[0] + ui.frame.picture[2] - width - 12 * ui.shared.scale,
           ui.frame.picture[1] + 8 * ui.shared.scale},
          text);
}

/// Drags from point to point of the mouse's way since the last frame, so that the result does not depend on
/// how many frames there were.
void dragAlongWay(Ui& ui, MouseUse& use) {
    const ImGuiIO& io = ImGui::GetIO();
    const Gesture gesture = gestureOf(use.button, io.KeyCtrl, io.KeyShift);
    ImVec2 at{io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y};
    const auto dragTo = [&](float x, float y) {
        const float right = x - at.x, down = y - at.y;
        at = {x, y};
        if (right == 0 && down == 0) return;
        use.length += std::hypot(right, down);
        ui.look.drag(ui.mode, dragOf(ui, gesture, right, down));
    };
    for (const MousePoint& each : ui.frame.way)
        dragTo(static_cast<float>(each.x), static_cast<float>(each.y));
    dragTo(io.MousePos.x, io.MousePos.y);
}

void pictureInput(Ui& ui, MouseUse& use) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool isOver = !io.WantCaptureMouse && isInPicture(ui, io.MousePos);
    if (isOver || use.button == ImGuiMouseButton_Left)
        ui.session.setMouse(
            std::clamp((io.MousePos.x - ui.frame.picture[0]) / ui.frame.picture[2], 0.F, 1.F),
            std::clamp(1 - (io.MousePos.y - ui.frame.picture[1]) / ui.frame.picture[3], 0.F, 1.F),
            ImGui::IsMouseDown(ImGuiMouseButton_Left));
    bool begins = false;
    if (use.button < 0 && isOver) {
        for (int button = 0; button < 3; ++button)
            if (ImGui::IsMouseClicked(button)) {
                use.button = button;
                use.length = 0;
                begins = true;
            }
        if (const double notches = use.wheel.take(io.MouseWheel, ImGui::GetTime()); notches != 0)
            ui.look.drag(ui.mode, dragOf(ui, Gesture::scale, 0, static_cast<float>(-notches) * kWheelPixels));
    }
    if (use.button < 0) return;
    if (ImGui::IsMouseDown(use.button)) {
        if (!begins) dragAlongWay(ui, use);  // the way to the first point belongs to no drag
        return;
    }
    if (use.button == ImGuiMouseButton_Left && use.length < kClickPixels) {
        const double perUnit = ui.look.width() / static_cast<double>(ui.frame.picture[2]);
        const int x = static_cast<int>((io.MousePos.x - ui.frame.picture[0]) * perUnit);
        const int y = static_cast<int>((io.MousePos.y - ui.frame.picture[1]) * perUnit);
        if (toolWindow(ui, "probe").isOpen)
            ui.wanted.probed = std::pair(x, y);
        else
            ui.session.pickAt(x, y);
    }
    use.button = -1;
}

void pictureOverlay(Ui& ui, LabelOverlay& labels) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({ui.frame.picture[0], ui.frame.picture[1]},
                      {ui.frame.picture[0] + ui.frame.picture[2], ui.frame.picture[1] + ui.frame.picture[3]});
    if (ui.session.hasScene()) {
        labelOverlay(ui, labels);
        if (ui.look.picked() && ui.session.picture()) cursor(ui, list);
        if (ui.session.measuresObjects()) frameRate(ui, list);
    } else {
        const char* text = "Drop a .glib file here, press Ctrl+O to open one, or X for examples";
        const ImVec2 size = ImGui::CalcTextSize(text);
        list.AddText({ui.frame.picture[0] + (ui.frame.picture[2] - size.x) / 2,
                      ui.frame.picture[1] + ui.frame.picture[3] / 2},
                     ImGui::GetColorU32(ImGuiCol_Text), text);
    }
    list.PopClipRect();
}

class Picture final : public Panel {
  public:
    void show(Ui& ui) override {
        pictureInput(ui, use_);
        ui.frame.isDragging = use_.button >= 0;
    }
    void drawOver(Ui& ui) override { pictureOverlay(ui, labels_); }
    void addTo(nlohmann::ordered_json& state, const Ui& ui) const override {
        state["labels"] =
            labels_.texture && ui.shared.showLabels ? labels_.lines : std::vector<std::string>();
    }
    void releaseDevice() override { labels_ = {}; }

  private:
    MouseUse use_;
    LabelOverlay labels_;
};

}  // namespace

const PanelRow kPictureRow{.name = "picture", .place = PanelPlace::picture, .make = make<Picture>};

std::string labelKey(const render::Knob& knob) {
    return knob.title + "/" + knob.tag;
}

void labelChoice(Ui& ui, const char* id, const char* name, float width) {
    constexpr std::array kChoices{std::pair{LabelChoice::all, "all"},
                                  std::pair{LabelChoice::changed, "changed"},
                                  std::pair{LabelChoice::chosen, "chosen"}};
    ImGui::SetNextItemWidth(width);
    if (beginCombo(ui, id, kChoices.at(static_cast<std::size_t>(ui.settings.labelChoice)).second, name)) {
        for (const auto& [which, words] : kChoices)
            if (choice(ui, words, which == ui.settings.labelChoice, "{}/{}", name, words))
                ui.settings.labelChoice = which;
        ImGui::EndCombo();
    } else {
        tooltip(
            "Which values are labelled: all, those that differ from the scene's,\n"
            "or those that 'Label on the picture' in the menu of a value chooses");
    }
}

}  // namespace glibra::view
