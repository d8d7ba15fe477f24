#pragma once
// Black and white patterns that are hard to sample, drawn at any number of samples per pixel.

#include <glibra/result.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/vertex_array.h"

namespace glibra::bench {

/// One way of drawing a pattern over the bound target.
struct PatternProgram {
    std::string_view name;  ///< "step", or empty if there is only one way
    gpu::Program program;
};

struct Pattern {
    std::string_view name, title;
    std::vector<PatternProgram> programs;  ///< the first draws the pattern itself, sampled at points
    /// Exact integrals over the pixels of a side x side picture, rows from the top; empty if there is no
    /// closed form.
    std::function<std::vector<double>(int side)> exact;
    /// Corners of triangles; if absent, the program covers the whole target.
    std::optional<gpu::Buffer> corners;
    int cornerCount = 0;

    /// Draws over the bound target, which has been cleared to black, as for a picture of side x side pixels.
    void draw(const PatternProgram& program, int side) const;
};

/// A star of 17 narrow triangles (exact: clipped areas), an axis-parallel checkerboard of .83 x .61 pixels
/// per square (exact: product of two integrals), a checkerboard on a plane in perspective, and slanted
/// stripes of 24 to 1.3 pixels per period. The stripes are drawn with a step, a smooth step as wide as a
/// pixel, and the integrals over that width and over the square of the pixel.
Result<std::vector<Pattern>> patterns(const gpu::Capabilities& capabilities);

}  // namespace glibra::bench
