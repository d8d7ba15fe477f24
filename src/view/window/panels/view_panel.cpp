// The sections "Transforms" (what the mouse moves, the camera), "Shown" (what is drawn and how), and "Tools".

#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "render/draw/view_matrices.h"
#include "view/scene/slider_scale.h"
#include "view/window/panels/color_field.h"
#include "view/window/panels/debug_view_panel.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/number_field.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

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
        const auto& picked = ui.session.picked();
        if (!picked) {
            ImGui::TextDisabled("Click an object in the picture first.");
            return;
        }
        ImGui::Text("%s, line %d", picked->word.c_str(), picked->draw.line);
    }
    Similarity now = similarityOf(render::asMatrix(ui.session.transform(ui.mode)));
    bool changed = dragNumbers(ui, "Translate", &now.translation.x, 3, .01F);
    changed = dragNumbers(ui, "Rotate", &now.degrees.x, 3, .5F) || changed;
    changed = dragNumbers(ui, "Scale", &now.scale, 1, .01F) || changed;
    if (changed && now.scale > 0) ui.session.setTransform(ui.mode, render::asNumbers(matrixOf(now)));
    if (button(ui, "Reset this", "transform/resetThis")) ui.session.setTransform(ui.mode, kIdentity);
    continueRowForButton("Reset all transforms");
    if (button(ui, "Reset all transforms", "transform/reset")) ui.session.resetTransforms();
}

/// A menu of the scene's cameras.
void cameras(Ui& ui) {
    const auto& cameras = ui.session.live().cameras();
    if (cameras.empty()) return;
    const auto labelOf = [](const std::string& name) {
        return name.empty() ? "as in the scene" : name.c_str();
    };
    fieldLabel("Camera");
    const bool isOpen = beginCombo(ui, "##camera", labelOf(ui.session.camera()), "view/camera");
    if (!isOpen) return;
    const auto item = [&](const std::string& name) {
        if (choice(ui, labelOf(name), name == ui.session.camera(), "view/camera/{}",
                   name.empty() ? "scene" : name))
            ui.session.setCamera(name);
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
    ViewState view = ui.session.view();
    int mode = static_cast<int>(view.projection);
    fieldLabel("Projection");
    const bool isChanged =
        ImGui::Combo("##projection", &mode, "as in the scene\0perspective\0orthographic\0");
    mark(ui, "view/projection");
    if (!isChanged) return;
    view.projection = static_cast<ProjectionMode>(mode);
    ui.session.setView(std::move(view));
}

void ownBackground(Ui& ui) {
    ViewState view = ui.session.view();
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
    if (isChanged) ui.session.setView(std::move(view));
}

void drawnParts(Ui& ui) {
    bool axes = ui.session.axes();
    if (checkBox(ui, "Axes", "view/axes", axes)) ui.session.setAxes(axes);
    continueRowForCheck("Wireframe");
    bool wireframe = ui.session.wireframe();
    if (checkBox(ui, "Wireframe", "view/wireframe", wireframe)) ui.session.setWireframe(wireframe);
    ownBackground(ui);
}

/// How the picture stands on the screen: nothing here changes what is written to files.
void screen(Ui& ui) {
    constexpr std::array<std::pair<PictureShape, const char*>, 2> kShapes{
        {{PictureShape::scene, "as in the scene"}, {PictureShape::fill, "fill the window"}}};
    const bool isFilled = ui.settings.pictureShape == PictureShape::fill;
    fieldLabel("Shape");
    const bool showsShapes = beginCombo(ui, "##shape", kShapes[isFilled ? 1 : 0].second, "view/shape");
    if (showsShapes) {
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
    const bool isOpen = beginCombo(ui, "##smooth", now, "view/samples");
    if (isOpen) {
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
    if (!ui.session.camera().empty()) {
        ui.session.setCamera("");
        ui.session.setTransform(TransformMode::eye, kIdentity);
        return;
    }
    ui.session.nextProjection();
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
     [](Ui& ui, Panel&) { ui.session.resetTransforms(); }},
    {KeyGroup::view, GLFW_KEY_C, false, "C", "look through the scene's next camera",
     [](Ui& ui, Panel&) { ui.session.nextCamera(); }},
    {KeyGroup::view, GLFW_KEY_P, false, "P",
     "orthographic or perspective, then as in the scene; first back to its own camera", nextProjection},
    {KeyGroup::view, GLFW_KEY_A, false, "A", "show axes",
     [](Ui& ui, Panel&) { ui.session.setAxes(!ui.session.axes()); }},
    {KeyGroup::view, GLFW_KEY_W, false, "W", "show wireframe",
     [](Ui& ui, Panel&) { ui.session.setWireframe(!ui.session.wireframe()); }},
    // Without keys: for the list of commands.
    {KeyGroup::view, kNoKey, false, "", "reset the transform that the mouse changes",
     [](Ui& ui, Panel&) { ui.session.setTransform(ui.mode, kIdentity); }},
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
         ViewState view = ui.session.view();
         if (view.background)
             view.background.reset();
         else
             view.background = {0, 0, 0, 1};
         ui.session.setView(std::move(view));
     }},
});

}  // namespace

const PanelRow kViewRow{
    .name = "view", .place = PanelPlace::section, .make = make<Drawn<viewPanel>>, .keys = kViewKeys};

}  // namespace glibra::view
