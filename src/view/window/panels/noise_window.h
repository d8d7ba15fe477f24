#pragma once
// The noise functions, to be played with: graph, points, colours, files.

#include <array>
#include <optional>
#include <string>

#include "gpu/texture.h"
#include "noise/noise_file.h"

namespace glibra::view {

struct NoiseWindow {
    bool isOpen = false;
    noise::NoiseFile noise;
    int chosen = 2;  ///< a point of the first octave
    enum class Drag { none, height, gradient } drag = Drag::none;
    std::array<char, 1024> file{"noise.png"};
    std::string message;  ///< how the last file went
    bool failed = false;
    std::optional<gpu::Texture> picture;  ///< of two dimensions, as `drawn` and `drawnColors` say
    noise::GraphOptions drawn;
    noise::ColorScale drawnColors = noise::ColorScale::grey;
};

}  // namespace glibra::view
