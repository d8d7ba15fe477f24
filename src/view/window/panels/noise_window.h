#pragma once
// The state of the noise window, where users experiment with noise functions: graph, points, colours, files.

#include <array>
#include <optional>
#include <string>

#include "gpu/object/texture.h"
#include "noise/noise_file.h"

namespace glibra::view {

inline constexpr double kSteepest = 8;  ///< limit of gradients set by hand, height per cell

struct Ui;

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

/// The graph in the noise window, with points to drag.
void noiseGraph(Ui& ui, NoiseState& window, float width, float height);

}  // namespace glibra::view
