#include "view/window/panels/noise_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "view/window/panels/ui.h"
#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr int kPictureSide = 160;  ///< pixels of the picture in the window
constexpr float kPanelWidth = 300;

template <std::size_t N, class Enumerator>
void noiseMenu(Ui& ui, const char* label, const std::array<const char*, N>& words, Enumerator& value) {
    if (!ImGui::BeginCombo(label, words.at(static_cast<std::size_t>(value)))) {
        markField(ui, fmt::format("noise/{}", label), label);
        return;
    }
    markField(ui, fmt::format("noise/{}", label), label);
    for (std::size_t i = 0; i < N; ++i) {
        if (ImGui::Selectable(words.at(i), static_cast<std::size_t>(value) == i))
            value = static_cast<Enumerator>(i);
        mark(ui, "noise/{}/{}", label, words.at(i));
    }
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
        std::erase_if(options.heights, isGone);
        std::erase_if(options.gradients, isGone);
        std::erase_if(options.curvatures, isGone);
        window.chosen = std::min(window.chosen, options.cells - 1);
    }
    checkBox("Turbulence", &options.turbulence);
    mark(ui, "noise/Turbulence");
    ImGui::SameLine();
    if (ImGui::Button("New random numbers")) ++options.seed;
    mark(ui, "noise/Seed");
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
    if (ImGui::Button("Reset point")) {
        options.heights.erase(window.chosen);
        options.gradients.erase(window.chosen);
        options.curvatures.erase(window.chosen);
    }
    mark(ui, "noise/ResetPoint");
    ImGui::SameLine();
    if (ImGui::Button("Reset all")) {
        options.heights.clear();
        options.gradients.clear();
        options.curvatures.clear();
    }
    mark(ui, "noise/ResetAll");
}

void writeNoiseFile(NoiseState& window, int dimensions) {
    window.noise.options.dimensions = dimensions;
    window.noise.width = std::clamp(window.noise.width, 1, 16384);
    window.noise.height = std::clamp(window.noise.height, 1, 16384);
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
    std::array<int, 2> size{window.noise.width, window.noise.height};
    if (ImGui::InputInt2("Size", size.data())) {
        window.noise.width = std::clamp(size[0], 1, 16384);
        window.noise.height = std::clamp(size[1], 1, 16384);
    }
    markField(ui, "noise/Size", "Size");
    if (ImGui::Button("Write graph")) writeNoiseFile(window, 1);
    mark(ui, "noise/WriteGraph");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The file name ends in .png, .svg, or .tex for a raw one-dimensional texture");
    ImGui::SameLine();
    if (ImGui::Button("Write picture")) writeNoiseFile(window, 2);
    mark(ui, "noise/WritePicture");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The file name ends in .png, or .tex for a raw two-dimensional texture");
    if (ImGui::Button("Copy command"))
        ImGui::SetClipboardText(noise::noiseCommand(window.noise, window.file.data()).c_str());
    mark(ui, "noise/Copy");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Copy the command line that writes the same file as the last button");
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
        Result<gpu::Texture> made = gpu::Texture::create(
            ui.context.capabilities(), gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
            {kPictureSide, kPictureSide, 1}, {std::as_bytes(std::span(pixels)), 3});
        window.picture = std::move(made.value);
        window.drawn = plane;
        window.drawnColors = window.noise.colors;
        if (window.picture) {
            glBindTexture(GL_TEXTURE_2D, window.picture->id());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        }
    }
    if (!window.picture) return;
    ImGui::Image(std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(window.picture->id())), {side, side});
    mark(ui, "noise/picture");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Two-dimensional noise; its lower edge is the graph");
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
