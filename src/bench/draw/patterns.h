#pragma once
// Patterns that are hard to sample: black and white, drawn at any number of samples a pixel.

#include <glibra/result.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"

namespace glibra::bench {

/// One way of drawing a pattern over the bound target.
struct PatternProgram {
    std::string_view name;  ///< "step", or empty if there is one way only
    gpu::Program program;
};

struct Pattern {
    std::string_view name, title;
    std::vector<PatternProgram> programs;  ///< the first is the pattern itself, sampled at points
    /// Exact integrals over the pixels of a side x side picture, rows from the top; empty if there is no
    /// closed form.
    std::function<std::vector<double>(int side)> exact;
    /// Corners of triangles; none: the program covers the whole target.
    std::optional<gpu::Buffer> corners;
    int cornerCount = 0;

    /// Draws over the bound target, cleared to black before, as for a picture of side x side pixels.
    void draw(const PatternProgram& program, int side) const;
};

/// A star of 17 narrow triangles (exact: clipped areas), an axis-parallel checkerboard of .83 x .61 pixels a
/// square (exact: product of two integrals), a checkerboard on a plane in perspective, and slanted stripes
/// from 24 to 1.3 pixels a period, drawn with a step, a smooth step of the pixel's width, and the integrals
/// over that width and over the pixel's square.
Result<std::vector<Pattern>> patterns(const gpu::Capabilities& capabilities);

}  // namespace glibra::bench
