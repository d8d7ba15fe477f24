// The sections "Transforms" (what the mouse moves, the camera), "Shown" (what is drawn and how), and "Tools".

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/draw/view_matrices.h"
#include "view/scene/slider_scale.h"
#include "view/scene/window_target.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"

namespace glibra::view {
namespace {

// What is shown in place of the picture.

const char* helpOf(DebugView kind) {
    switch (kind) {
        case DebugView::picture:
            return "The rendered picture";
        case DebugView::normals:
            return "Yellow: normals of vertices that only the scene's matrices move. Cyan: the direction "
                   "that each triangle faces after all stages. With a geometry stage, colours show that "
                   "direction.";
        case DebugView::coordinates:
            return "Red: s. Green: t. Blue is added outside 0 to 1. After tessellation and geometry stages, "
                   "this shows what the fragment stage gets as vST.";
        case DebugView::facing:
            return "Blue: front side. Orange: back side";
        case DebugView::overdraw:
            return "How many fragments passed the depth test at each pixel, in drawing order";
        case DebugView::layers:
            return "How many surfaces cover each pixel, including hidden ones";
        case DebugView::depth:
            break;
    }
    return "Distance from the eye: white is nearest";
}

struct LegendEntry {
    std::optional<std::array<std::uint8_t, 3>> color;
    std::string text;
};

/// What the colours of the view mean.
std::vector<LegendEntry> legendOf(DebugView kind, const ValueRange& range) {
    using Color3 = std::array<std::uint8_t, 3>;
    std::vector<LegendEntry> entries;
    if (kind == DebugView::overdraw || kind == DebugView::layers) {
        if (range.isEmpty) return entries;
        constexpr int kColors = 8;
        for (int count = 1; count <= kColors; ++count)
            entries.push_back({colorOfCount(count), std::to_string(count) + (count == kColors ? "+" : "")});
        entries.push_back({std::nullopt, fmt::format("most: {:g}", range.highest)});
    } else if (kind == DebugView::depth) {
        if (range.isEmpty) return entries;
        entries.push_back({Color3{255, 255, 255}, fmt::format("{:.4g}", range.lowest)});
        entries.push_back({Color3{0, 0, 0}, fmt::format("{:.4g} from the eye", range.highest)});
    } else if (kind == DebugView::facing) {
        entries = {{Color3{70, 130, 220}, "front"}, {Color3{235, 120, 40}, "back"}};
    } else if (kind == DebugView::coordinates) {
        entries = {{Color3{255, 0, 0}, "s"}, {Color3{0, 255, 0}, "t"}, {Color3{0, 0, 255}, "outside 0 to 1"}};
    } else if (kind == DebugView::normals) {
        entries = {{Color3{255, 217, 51}, "normals"}, {Color3{77, 230, 255}, "facing"}};
    }
    return entries;
}

/// True if the window shows only what a Fill makes of other passes.
bool isFillAlone(const scene::Scene& scene) {
    const std::vector<const scene::Draw*> draws = windowDraws(scene);
    return !draws.empty() && std::ranges::all_of(draws, [](const scene::Draw* each) { return each->isFill; });
}

/// The legend on the upper left corner of the picture, as far as it is seen. Returns its text.
std::string drawLegend(const Ui& ui, DebugView kind, const std::vector<LegendEntry>& entries) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float gap = 6 * ui.shared.scale, side = ImGui::GetTextLineHeight();
    std::string text(nameOf(kind));
    float width = ImGui::CalcTextSize(text.c_str()).x + gap;
    for (const LegendEntry& each : entries)
        width += (each.color ? side + gap / 2 : 0) + ImGui::CalcTextSize(each.text.c_str()).x + gap;
    ImVec2 at(std::max(ui.frame.picture[0], ui.frame.covered) + 2 * gap, ui.frame.picture[1] + 2 * gap);
    list.PushClipRect({ui.frame.picture[0], ui.frame.picture[1]},
                      {ui.frame.picture[0] + ui.frame.picture[2], ui.frame.picture[1] + ui.frame.picture[3]});
    list.AddRectFilled({at.x - gap, at.y - gap}, {at.x + width, at.y + side + gap}, IM_COL32(0, 0, 0, 190),
                       gap / 2);
    const auto write = [&](const std::string& words) {
        list.AddText(at, IM_COL32_WHITE, words.c_str());
        at.x += ImGui::CalcTextSize(words.c_str()).x + gap;
    };
    write(text);
    for (const LegendEntry& each : entries) {
        if (each.color) {
            const auto& [red, green, blue] = *each.color;
            list.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(red, green, blue, 255));
            list.AddRect(at, {at.x + side, at.y + side}, IM_COL32(255, 255, 255, 90));
            at.x += side + gap / 2;
        }
        write(each.text);
        text += " " + each.text;
    }
    list.PopClipRect();
    return text;
}

/// The debug view's numbers of the pixel under the mouse.
void debugViewUnderMouse(Ui& ui, std::string& text) {
    const std::string before = std::exchange(text, {});
    const TexelImage& numbers = ui.session.debugNumbers();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (numbers.rgba.empty() || ImGui::GetIO().WantCaptureMouse || ui.frame.isDragging ||
        ui.frame.picture[2] <= 0)
        return;
    const float perUnit = static_cast<float>(numbers.width) / ui.frame.picture[2];
    const int x = static_cast<int>((mouse.x - ui.frame.picture[0]) * perUnit);
    const int y = numbers.height - 1 - static_cast<int>((mouse.y - ui.frame.picture[1]) * perUnit);
    if (mouse.x < ui.frame.picture[0] || mouse.y < ui.frame.picture[1] || x >= numbers.width || y < 0) return;
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(numbers.width) +
                                static_cast<std::size_t>(x));
    text = wordsOf(ui.look.debugView(), numbers.rgba.data() + at);
    ImGui::SetTooltip("%s", text.c_str());
    // Its window gets the size of the text one frame later.
    if (text != before) ui.frame.isFollowed = true;
}

class DebugViewPanel final : public Panel {
  public:
    void show(Ui& ui) override { debugViewUnderMouse(ui, text_); }
    void drawOver(Ui& ui) override {
        legend_.clear();
        const DebugView kind = ui.look.debugView();
        if (!ui.session.hasScene() || kind == DebugView::picture) return;
        if (std::exchange(drawn_, ui.session.framesDrawn()) != ui.session.framesDrawn())
            range_ = rangeOf(kind, ui.session.debugNumbers());
        legend_ = drawLegend(ui, kind, legendOf(kind, range_));
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["debugViewText"] = text_;
        state["legend"] = legend_;
    }

  private:
    std::string text_, legend_;
    ValueRange range_;
    std::uint64_t drawn_ = 0;  ///< the frame of `range_`
};

void showNextDebugView(Ui& ui, Panel& /*panel*/) {
    ui.look.setDebugView(
        static_cast<DebugView>((static_cast<int>(ui.look.debugView()) + 1) % kDebugViewCount));
    ui.notice = "Show: " + std::string(nameOf(ui.look.debugView()));
}

constexpr auto kDebugViewKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_V, false, "V",
      "show normals, facing, overdraw, depth ... in place of the picture", showNextDebugView}});

/// The choice of a debug view ("Show") and its legend, and the switch of the probe: a part of the section
/// View.
void debugViewControls(Ui& ui) {
    const DebugView now = ui.look.debugView();
    fieldLabel("Show");
    if (beginCombo(ui, "##show", std::string(nameOf(now)).c_str(), "view/show")) {
        for (int i = 0; i < kDebugViewCount; ++i) {
            const auto kind = static_cast<DebugView>(i);
            const std::string name(nameOf(kind));
            if (choice(ui, name.c_str(), kind == now, "view/show/{}", name)) ui.look.setDebugView(kind);
            tooltip(helpOf(kind));
        }
        ImGui::EndCombo();
    } else if (ImGui::IsItemHovered()) {
        wrappedTooltip(helpOf(now), ImGui::GetFontSize() * 24);
    }
    if (now == DebugView::normals) {
        double length = ui.look.normalLength();
        fieldLabel("Length");
        if (labelledSlider(ui, "##length", "view/normalLength", {.005, 1, false, true}, length))
            ui.look.setNormalLength(length);
    }
    if (now != DebugView::picture && isFillAlone(ui.session.live().scene())) {
        ImGui::TextWrapped("Only a Fill draws into the window. Frame shows this for every pass.");
        if (smallButton(ui, "Frame", "view/showInFrame")) toolWindow(ui, "frame").isOpen = true;
    }
    checkBox(ui, "Probe a pixel", "view/probe", toolWindow(ui, "probe").isOpen,
             "Click the picture to see the inputs, outputs and uniforms of the fragment (D)");
}

struct ModeRow {
    TransformMode mode;
    const char* label;
    const char* help;
};
constexpr std::array<ModeRow, 4> kModes{
    {{TransformMode::scene, "Scene", "The mouse moves the whole scene, in the projection matrix (1)"},
     {TransformMode::eye, "Eye", "The mouse moves the eye, in the model-view matrix (2)"},
     {TransformMode::object, "Object", "The mouse moves the picked object, in its own model-view matrix (3)"},
     {TransformMode::texture, "Texture", "The mouse moves texture coordinates, in gl_TextureMatrix[0] (4)"}}};

void modes(Ui& ui) {
    for (const ModeRow& each : kModes) {
        if (each.mode != TransformMode::scene) continueRowForCheck(each.label);
        if (radioButton(each.label, ui.mode == each.mode)) ui.mode = each.mode;
        mark(ui, "mode/{}", each.label);
        tooltip(each.help);
    }
}

bool dragNumbers(Ui& ui, const char* label, double* values, int count, float speed) {
    fieldLabel(label);
    ImGui::PushID(label);
    ImGui::BeginGroup();
    const float space = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto number = static_cast<float>(count);
    const float width = (ImGui::GetContentRegionAvail().x - space * (number - 1)) / number;
    bool changed = false;
    for (int i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0, space);
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(std::max(20.F, width));
        if (const std::optional<bool> typed = typedInto(ui, "##number", values[i])) {
            changed = changed || *typed;
        } else if (ImGui::DragScalar("##number", ImGuiDataType_Double, values + i, speed, nullptr, nullptr,
                                     "%.4g")) {
            changed = true;
            if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
                values[i] = withoutLeftover(values[i], static_cast<double>(speed));
        }
        tabStop(ui);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format("transform/{}", label));
    ImGui::PopID();
    return changed;
}

void numbers(Ui& ui) {
    if (ui.mode == TransformMode::object) {
        const auto& picked = ui.look.picked();
        if (!picked) {
            ImGui::TextDisabled("Click an object in the picture first.");
            return;
        }
        ImGui::Text("%s, line %d", picked->word.c_str(), picked->draw.line);
    }
    Similarity now = similarityOf(render::asMatrix(ui.look.transform(ui.mode)));
    bool changed = dragNumbers(ui, "Translate", &now.translation.x, 3, .01F);
    changed = dragNumbers(ui, "Rotate", &now.degrees.x, 3, .5F) || changed;
    changed = dragNumbers(ui, "Scale", &now.scale, 1, .01F) || changed;
    if (changed && now.scale > 0) ui.look.setTransform(ui.mode, render::asNumbers(matrixOf(now)));
    if (button(ui, "Reset this", "transform/resetThis")) ui.look.setTransform(ui.mode, kIdentity);
    continueRowForButton("Reset all transforms");
    if (button(ui, "Reset all transforms", "transform/reset")) ui.look.resetTransforms();
}

/// A menu of the scene's cameras.
void cameras(Ui& ui) {
    const auto& cameras = ui.session.live().cameras();
    if (cameras.empty()) return;
    const auto labelOf = [](const std::string& name) {
        return name.empty() ? "as in the scene" : name.c_str();
    };
    fieldLabel("Camera");
    if (!beginCombo(ui, "##camera", labelOf(ui.look.camera()), "view/camera")) return;
    const auto item = [&](const std::string& name) {
        if (choice(ui, labelOf(name), name == ui.look.camera(), "view/camera/{}",
                   name.empty() ? "scene" : name))
            ui.look.setCamera(name);
    };
    item("");
    for (const auto& each : cameras) item(std::string(each.name));
    ImGui::EndCombo();
}

/// Check boxes that open and close tool windows.
void toolWindows(Ui& ui) {
    bool isFirst = true;
    for (const PanelUse& each : ui.panels) {
        if (!each.row->checkBox) continue;
        if (!std::exchange(isFirst, false)) continueRowForCheck(each.row->checkBox);
        checkBox(each.row->checkBox, &each.panel->isOpen);
        mark(ui, "view/{}", each.row->name);
        tooltip(each.row->help);
    }
}

void projection(Ui& ui) {
    ViewState view = ui.look.view();
    int mode = static_cast<int>(view.projection);
    fieldLabel("Projection");
    const bool isChanged =
        ImGui::Combo("##projection", &mode, "as in the scene\0perspective\0orthographic\0");
    mark(ui, "view/projection");
    if (!isChanged) return;
    view.projection = static_cast<ProjectionMode>(mode);
    ui.look.setView(std::move(view));
}

void ownBackground(Ui& ui) {
    ViewState view = ui.look.view();
    bool own = view.background.has_value();
    continueRowForCheck("Background");
    bool isChanged = checkBox(ui, "Background", "view/ownBackground", own);
    if (isChanged && own)
        view.background = {0, 0, 0, 1};
    else if (isChanged)
        view.background.reset();
    if (view.background) {
        std::array<float, 4> rgba{0, 0, 0, 1};
        for (std::size_t i = 0; i < 3; ++i) rgba[i] = static_cast<float>((*view.background)[i]);
        ImGui::SameLine();
        if (colorSwatch(ui, "background", "view/background", rgba, false)) {
            view.background = {rgba[0], rgba[1], rgba[2], 1};
            isChanged = true;
        }
    }
    if (isChanged) ui.look.setView(std::move(view));
}

void drawnParts(Ui& ui) {
    bool axes = ui.look.axes();
    if (checkBox(ui, "Axes", "view/axes", axes)) ui.look.setAxes(axes);
    continueRowForCheck("Wireframe");
    bool wireframe = ui.look.wireframe();
    if (checkBox(ui, "Wireframe", "view/wireframe", wireframe)) ui.look.setWireframe(wireframe);
    ownBackground(ui);
}

/// How the picture stands on the screen: nothing here changes what is written to files.
void screen(Ui& ui) {
    constexpr std::array<std::pair<PictureShape, const char*>, 2> kShapes{
        {{PictureShape::scene, "as in the scene"}, {PictureShape::fill, "fill the window"}}};
    const bool isFilled = ui.settings.pictureShape == PictureShape::fill;
    fieldLabel("Shape");
    if (beginCombo(ui, "##shape", kShapes[isFilled ? 1 : 0].second, "view/shape")) {
        for (const auto& [shape, words] : kShapes)
            if (choice(ui, words, shape == ui.settings.pictureShape, "view/shape/{}",
                       shape == PictureShape::fill ? "fill" : "scene"))
                ui.settings.pictureShape = shape;
        ImGui::EndCombo();
    } else {
        tooltip(
            "As in the scene: the picture keeps the shape of the scene's window, with margins.\n"
            "Fill the window: the scene fits in by the smaller side. Nothing is cropped.");
    }
    constexpr std::array<std::pair<int, const char*>, 4> kChoices{
        {{1, "off"}, {2, "2 samples per pixel"}, {4, "4 samples per pixel"}, {8, "8 samples per pixel"}}};
    const int samples = std::max(1, ui.shared.samples.value_or(ui.settings.samples));
    const char* now = "as the command line says";
    for (const auto& [count, words] : kChoices)
        if (count == samples) now = words;
    fieldLabel("Smooth");
    if (beginCombo(ui, "##smooth", now, "view/samples")) {
        for (const auto& [count, words] : kChoices)
            if (choice(ui, words, count == samples, "view/samples/{}", count)) {
                ui.settings.samples = count;
                ui.shared.samples.reset();
            }
        ImGui::EndCombo();
    } else {
        tooltip(
            "Smooth edges on the screen, where the driver can; hardcopies are as smooth, unless their "
            "section says otherwise");
    }
}

void viewPanel(Ui& ui) {
    if (section(ui, "Transforms", "transforms", false)) {
        modes(ui);
        numbers(ui);
        cameras(ui);
        projection(ui);
    }
    if (section(ui, "Shown", "shown", false)) {
        debugViewControls(ui);
        drawnParts(ui);
        screen(ui);
    }
    if (section(ui, "Tools", "toolWindows", false)) toolWindows(ui);
}

/// Back to the scene's own camera, if the user looks through another one.
void nextProjection(Ui& ui, Panel& /*panel*/) {
    if (!ui.look.camera().empty()) {
        ui.look.setCamera("");
        ui.look.setTransform(TransformMode::eye, kIdentity);
        return;
    }
    ui.look.nextProjection();
}

template <TransformMode mode>
void setMode(Ui& ui, Panel& /*panel*/) {
    ui.mode = mode;
}

constexpr auto kViewKeys = std::to_array<Shortcut>({
    {KeyGroup::view, GLFW_KEY_1, false, "1", "the mouse moves the scene", setMode<TransformMode::scene>},
    {KeyGroup::view, GLFW_KEY_2, false, "2", "the mouse moves the eye", setMode<TransformMode::eye>},
    {KeyGroup::view, GLFW_KEY_3, false, "3", "the mouse moves the picked object",
     setMode<TransformMode::object>},
    {KeyGroup::view, GLFW_KEY_4, false, "4", "the mouse moves texture coordinates",
     setMode<TransformMode::texture>},
    {KeyGroup::view, GLFW_KEY_R, false, "R", "reset all transforms, keep the values",
     [](Ui& ui, Panel&) { ui.look.resetTransforms(); }},
    {KeyGroup::view, GLFW_KEY_C, false, "C", "look through the scene's next camera",
     [](Ui& ui, Panel&) { ui.look.nextCamera(); }},
    {KeyGroup::view, GLFW_KEY_P, false, "P",
     "orthographic or perspective, then as in the scene; first back to its own camera", nextProjection},
    {KeyGroup::view, GLFW_KEY_A, false, "A", "show axes",
     [](Ui& ui, Panel&) { ui.look.setAxes(!ui.look.axes()); }},
    {KeyGroup::view, GLFW_KEY_W, false, "W", "show wireframe",
     [](Ui& ui, Panel&) { ui.look.setWireframe(!ui.look.wireframe()); }},
    // Without keys: for the list of commands.
    {KeyGroup::view, kNoKey, false, "", "reset the transform that the mouse changes",
     [](Ui& ui, Panel&) { ui.look.setTransform(ui.mode, kIdentity); }},
    {KeyGroup::view, kNoKey, false, "", "picture fills the window, or keeps the shape of the scene",
     [](Ui& ui, Panel&) {
         const bool isFilled = ui.settings.pictureShape == PictureShape::fill;
         ui.settings.pictureShape = isFilled ? PictureShape::scene : PictureShape::fill;
     }},
    {KeyGroup::view, kNoKey, false, "", "smooth edges, on or off",
     [](Ui& ui, Panel&) {
         constexpr int kSmooth = 4;
         ui.settings.samples = ui.shared.samples.value_or(ui.settings.samples) > 1 ? 1 : kSmooth;
         ui.shared.samples.reset();
     }},
    {KeyGroup::view, kNoKey, false, "", "background of another colour, or that of the scene",
     [](Ui& ui, Panel&) {
         ViewState view = ui.look.view();
         if (view.background)
             view.background.reset();
         else
             view.background = {0, 0, 0, 1};
         ui.look.setView(std::move(view));
     }},
});

}  // namespace

const PanelRow kDebugViewRow{
    .name = "debugView", .place = PanelPlace::picture, .make = make<DebugViewPanel>, .keys = kDebugViewKeys};

const PanelRow kViewRow{
    .name = "view", .place = PanelPlace::section, .make = make<Drawn<viewPanel>>, .keys = kViewKeys};

}  // namespace glibra::view
