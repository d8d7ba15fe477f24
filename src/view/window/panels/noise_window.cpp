#include "view/window/panels/noise_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "view/window/panels/number_field.h"
#include "view/window/panels/shown_texture.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr int kPictureSide = 160;  ///< pixels of the picture in the window
constexpr float kPanelWidth = 300;

template <std::size_t N, class Enumerator>
void noiseMenu(Ui& ui, const char* label, const std::array<const char*, N>& words, Enumerator& value) {
    const bool isOpen = ImGui::BeginCombo(label, words.at(static_cast<std::size_t>(value)));
    markField(ui, fmt::format("noise/{}", label), label);
    if (!isOpen) return;
    for (std::size_t i = 0; i < N; ++i)
        if (choice(ui, words.at(i), static_cast<std::size_t>(value) == i, "noise/{}/{}", label, words.at(i)))
            value = static_cast<Enumerator>(i);
    ImGui::EndCombo();
}

bool countSlider(Ui& ui, const char* label, int least, int most, int& count) {
    double value = count;
    const SliderScale scale{static_cast<double>(least), static_cast<double>(most), true};
    const bool isChanged = labelledSlider(ui, label, fmt::format("noise/{}", label), scale, value);
    count = static_cast<int>(std::lround(value));
    return isChanged;
}

void functionControls(Ui& ui, NoiseState& window) {
    noise::GraphOptions& options = window.noise.options;
    noiseMenu(ui, "Lattice", noise::kLatticeWords, options.lattice);
    noiseMenu(ui, "Smoothness", noise::kSmoothnessWords, options.smoothness);
    ImGui::BeginDisabled(options.lattice != noise::Lattice::value);
    noiseMenu(ui, "Gradients", noise::kSlopesWords, options.slopes);
    ImGui::EndDisabled();
    constexpr int kMostShownPoints = 64;
    countSlider(ui, "Octaves", 1, noise::kMostGraphOctaves, options.octaves);
    if (countSlider(ui, "Points", 2, kMostShownPoints, options.cells)) {
        const auto isGone = [&](const auto& each) { return each.first >= options.cells; };
        for (auto* each : {&options.heights, &options.gradients, &options.curvatures})
            std::erase_if(*each, isGone);
        window.chosen = std::min(window.chosen, options.cells - 1);
    }
    checkBox(ui, "Turbulence", "noise/Turbulence", options.turbulence);
    ImGui::SameLine();
    if (button(ui, "New random numbers", "noise/Seed")) ++options.seed;
}

void pointSlider(Ui& ui, int point, const char* label, double value, double limit,
                 std::map<int, double>& values) {
    if (labelledSlider(ui, label, fmt::format("noise/{}", label), {-limit, limit}, value))
        values[point] = value;
}

void pointControls(Ui& ui, NoiseState& window) {
    noise::GraphOptions& options = window.noise.options;
    const noise::GraphPoint point = noise::graphPoint(options, window.chosen);
    ImGui::Text("Point %d", window.chosen);
    ImGui::BeginDisabled(options.lattice == noise::Lattice::gradient);
    pointSlider(ui, window.chosen, "Height", point.height, 1, options.heights);
    ImGui::EndDisabled();
    ImGui::BeginDisabled(options.lattice == noise::Lattice::value);
    pointSlider(ui, window.chosen, "Gradient", point.gradient, kSteepest, options.gradients);
    ImGui::EndDisabled();
    ImGui::BeginDisabled(options.smoothness == noise::Smoothness::cubic);
    constexpr double kMostCurved = 40;
    pointSlider(ui, window.chosen, "Curvature", point.curvature, kMostCurved, options.curvatures);
    ImGui::EndDisabled();
    if (button(ui, "Reset point", "noise/ResetPoint"))
        for (auto* each : {&options.heights, &options.gradients, &options.curvatures})
            each->erase(window.chosen);
    ImGui::SameLine();
    if (button(ui, "Reset all", "noise/ResetAll"))
        for (auto* each : {&options.heights, &options.gradients, &options.curvatures}) each->clear();
}

void writeNoiseFile(NoiseState& window, int dimensions) {
    window.noise.options.dimensions = dimensions;
    const std::string file = window.file.data();
    if (dimensions == 2 && noise::endingOf(file) == ".svg") {
        window.message = "an SVG file can only hold a graph; choose .png or .tex";
        window.failed = true;
        return;
    }
    const Diagnostics problems = noise::writeNoise(window.noise, file);
    window.failed = hasError(problems);
    window.message = problems.empty() ? "wrote " + file : problems.front().text;
}

void fileControls(Ui& ui, NoiseState& window) {
    ImGui::InputText("File", window.file.data(), window.file.size());
    markField(ui, "noise/File", "File");
    sidesEntry(ui, "Size", window.noise.width, window.noise.height, 16384);
    markPlace(ui, "noise/Size");
    if (button(ui, "Write graph", "noise/WriteGraph",
               "The file name ends in .png, .svg, or .tex for a raw one-dimensional texture"))
        writeNoiseFile(window, 1);
    ImGui::SameLine();
    if (button(ui, "Write picture", "noise/WritePicture",
               "The file name ends in .png, or .tex for a raw two-dimensional texture"))
        writeNoiseFile(window, 2);
    if (button(ui, "Copy command", "noise/Copy",
               "Copy the command line that writes the same file as the last button"))
        ImGui::SetClipboardText(noise::noiseCommand(window.noise, window.file.data()).c_str());
    if (window.failed)
        ImGui::TextColored(asVector(palette().error), "%s", window.message.c_str());
    else
        ImGui::TextDisabled("%s", window.message.c_str());
}

/// The coloured noise; it is only computed again after a change.
void noisePicture(Ui& ui, NoiseState& window, float side) {
    noise::GraphOptions plane = window.noise.options;
    plane.dimensions = 2;
    if (!window.picture || window.drawn != plane || window.drawnColors != window.noise.colors) {
        const std::vector<std::uint8_t> pixels =
            noise::noisePixels(plane, window.noise.colors, kPictureSide, kPictureSide);
        window.picture = textureOfBytes(ui.context.capabilities(), kPictureSide, kPictureSide,
                                        std::as_bytes(std::span(pixels)), GL_LINEAR, GL_LINEAR, 3);
        window.drawn = plane;
        window.drawnColors = window.noise.colors;
    }
    if (!window.picture) return;
    ImGui::Image(idOf(*window.picture), {side, side});
    mark(ui, "noise/picture");
    tooltip("Two-dimensional noise; its lower edge is the graph");
}

void noiseWindow(Ui& ui, NoiseState& window, bool& isOpen) {
    if (!isOpen) return;
    placeFloating(ui, 40, 30, 820, 560);
    if (ImGui::Begin(kNoiseRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float panel = std::min(kPanelWidth * ui.shared.scale, room.x / 2);
        ImGui::BeginChild("noise graphs", {room.x - panel - 8, 0});
        const float side = std::max(16.F, std::min(room.x - panel - 8, room.y / 2));
        noiseGraph(ui, window, std::max(16.F, room.x - panel - 8), std::max(16.F, room.y - side - 8));
        noisePicture(ui, window, side);
        ImGui::EndChild();
        ImGui::SameLine();
        ImGui::BeginChild("noise controls");
        ImGui::PushItemWidth(-ImGui::CalcTextSize("Smoothness ").x);
        functionControls(ui, window);
        ImGui::Separator();
        pointControls(ui, window);
        ImGui::Separator();
        noiseMenu(ui, "Colours", noise::kColorWords, window.noise.colors);
        fileControls(ui, window);
        ImGui::PopItemWidth();
        ImGui::EndChild();
    }
    ImGui::End();
}

class NoiseWindow final : public Panel {
  public:
    void show(Ui& ui) override { noiseWindow(ui, state_, isOpen); }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        if (isOpen)
            state["noise"] = {{"command", noise::noiseCommand(state_.noise, state_.file.data())},
                              {"point", state_.chosen},
                              {"message", state_.message}};
    }
    void releaseDevice() override { state_.picture.reset(); }

  private:
    NoiseState state_;
};

constexpr auto kNoiseKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_N, false, "N", "show noise functions", toggleOpen}});

}  // namespace

const PanelRow kNoiseRow{.name = "noise",
                         .place = PanelPlace::floating,
                         .make = make<NoiseWindow>,
                         .isShared = true,
                         .keys = kNoiseKeys,
                         .title = "Noise",
                         .checkBox = "Noise",
                         .help = "Show the noise functions as graphs (N)"};

}  // namespace glibra::view
