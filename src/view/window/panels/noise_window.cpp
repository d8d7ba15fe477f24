// The graph in the noise window: the curve over one period. Its points and the chosen point's gradient can be
// dragged.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/object/texture.h"
#include "noise/noise_file.h"
#include "view/window/panels/texel_view.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

// The state of the noise window, where users experiment with noise functions: graph, points, colours, files.

constexpr double kSteepest = 8;  ///< limit of gradients set by hand, height per cell

struct NoiseState {
    noise::NoiseFile noise;
    int chosen = 2;  ///< a point of the first octave
    enum class Drag { none, height, gradient } drag = Drag::none;
    std::array<char, 1024> file{"noise.png"};
    std::string message;  ///< the result of the last write
    bool failed = false;
    std::optional<gpu::Texture> picture;  ///< two-dimensional noise, drawn with `drawn` and `drawnColors`
    noise::GraphOptions drawn;
    noise::ColorScale drawnColors = noise::ColorScale::grey;
};

constexpr float kReachPixels = 9;     ///< how near the mouse must be to grab something
constexpr double kTangentCells = .3;  ///< from a point to either end of its gradient line

/// The graph's position on the screen, and its coordinates.
struct Graph {
    const noise::GraphOptions& options;
    ImVec2 at, size;
    double range;

    [[nodiscard]] ImVec2 screen(double x, double value) const {
        const double low = options.turbulence ? 0 : -range;
        return {at.x + static_cast<float>(x / options.cells) * size.x,
                at.y + static_cast<float>(1 - (value - low) / (range - low)) * size.y};
    }
    [[nodiscard]] double cellOf(float x) const {
        return static_cast<double>(x - at.x) / static_cast<double>(size.x) * options.cells;
    }
    [[nodiscard]] double valueOf(float y) const {
        const double low = options.turbulence ? 0 : -range;
        return low + (1 - static_cast<double>(y - at.y) / static_cast<double>(size.y)) * (range - low);
    }
};

float distance(const ImVec2& a, const ImVec2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

bool hasGradients(const noise::GraphOptions& options) {
    return options.lattice != noise::Lattice::value;
}
bool hasHeights(const noise::GraphOptions& options) {
    return options.lattice != noise::Lattice::gradient;
}

/// An end of the line that shows a point's gradient: the right end for side 1, the left end for -1.
ImVec2 tangentEnd(const Graph& graph, int point, double side) {
    const double gradient = noise::graphPoint(graph.options, point).gradient;
    return graph.screen(point + side * kTangentCells,
                        noise::graphNoise(graph.options, point) + side * kTangentCells * gradient);
}

void grab(NoiseState& window, const Graph& graph, const ImVec2& mouse) {
    window.drag = NoiseState::Drag::none;
    if (hasGradients(graph.options) &&
        (distance(mouse, tangentEnd(graph, window.chosen, 1)) < kReachPixels ||
         distance(mouse, tangentEnd(graph, window.chosen, -1)) < kReachPixels)) {
        window.drag = NoiseState::Drag::gradient;
        return;
    }
    // The period's last point is the same as its first.
    const int nearest = static_cast<int>(std::lround(graph.cellOf(mouse.x)));
    window.chosen = ((nearest % graph.options.cells) + graph.options.cells) % graph.options.cells;
    const ImVec2 point = graph.screen(nearest, noise::graphNoise(graph.options, nearest));
    if (hasHeights(graph.options) && distance(mouse, point) < kReachPixels)
        window.drag = NoiseState::Drag::height;
}

void dragTo(NoiseState& window, const Graph& graph, const ImVec2& mouse, const ImVec2& moved) {
    noise::GraphOptions& options = window.noise.options;
    if (window.drag == NoiseState::Drag::height) {
        const double change = graph.valueOf(mouse.y) - graph.valueOf(mouse.y - moved.y);
        const double height = noise::graphPoint(options, window.chosen).height;
        options.heights[window.chosen] =
            std::clamp(height + (options.turbulence && height < 0 ? -change : change), -1.0, 1.0);
    } else if (window.drag == NoiseState::Drag::gradient) {
        const double across = graph.cellOf(mouse.x) - window.chosen;
        if (std::abs(across) < kTangentCells / 4) return;
        const double rise = graph.valueOf(mouse.y) - noise::graphNoise(options, window.chosen);
        options.gradients[window.chosen] = std::clamp(rise / across, -kSteepest, kSteepest);
    }
}

void drawGraph(const NoiseState& window, const Graph& graph, ImDrawList& list) {
    const noise::GraphOptions& options = graph.options;
    list.AddRectFilled(graph.at, {graph.at.x + graph.size.x, graph.at.y + graph.size.y},
                       IM_COL32(250, 250, 250, 255));
    list.PushClipRect(graph.at, {graph.at.x + graph.size.x, graph.at.y + graph.size.y}, true);
    const ImVec2 zero = graph.screen(0, 0);
    list.AddLine({graph.at.x, zero.y}, {graph.at.x + graph.size.x, zero.y}, IM_COL32(150, 150, 150, 255));
    std::vector<ImVec2> curve;
    for (int column = 0; column <= static_cast<int>(graph.size.x); ++column) {
        const double cell = graph.cellOf(graph.at.x + static_cast<float>(column));
        curve.push_back(graph.screen(cell, noise::graphNoise(options, cell)));
    }
    list.AddPolyline(curve.data(), static_cast<int>(curve.size()), IM_COL32(31, 78, 156, 255), 0, 2);
    if (hasGradients(options))
        list.AddLine(tangentEnd(graph, window.chosen, -1), tangentEnd(graph, window.chosen, 1),
                     IM_COL32(30, 150, 60, 255), 2);
    for (int i = 0; i <= options.cells; ++i) {
        const bool isChosen = i % options.cells == window.chosen;
        list.AddCircleFilled(graph.screen(i, noise::graphNoise(options, i)), isChosen ? 6 : 4,
                             isChosen ? IM_COL32(30, 150, 60, 255) : IM_COL32(204, 51, 51, 255));
    }
    if (hasGradients(options))
        for (const double side : {-1.0, 1.0})
            list.AddCircleFilled(tangentEnd(graph, window.chosen, side), 4, IM_COL32(30, 150, 60, 255));
    list.PopClipRect();
}

/// The graph in the noise window, with points to drag.
void noiseGraph(Ui& ui, NoiseState& window, float width, float height) {
    ImGui::InvisibleButton("graph", {width, height});
    mark(ui, "noise/graph");
    const Graph graph{window.noise.options,
                      ImGui::GetItemRectMin(),
                      {width, height},
                      noise::graphRange(window.noise.options)};
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated()) {
        grab(window, graph, io.MousePos);
    } else if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        dragTo(window, graph, io.MousePos, io.MouseDelta);
    }
    if (!ImGui::IsItemActive()) window.drag = NoiseState::Drag::none;
    drawGraph(window, graph, *ImGui::GetWindowDrawList());
}

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
