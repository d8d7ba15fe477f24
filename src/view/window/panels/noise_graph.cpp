// The graph in the noise window: the curve over one period. Its points and the chosen point's gradient can be
// dragged.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/window/panels/noise_window.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

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

}  // namespace

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

}  // namespace glibra::view
