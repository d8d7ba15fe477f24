#pragma once

#include <cstdint>

namespace glibra::base {

/// What an evaluation stage states in its layout (OpenGL 4.6 Core, 11.2.2).
struct TessellationLayout {
    enum class Domain : std::uint8_t { triangles, quads, isolines };
    enum class Spacing : std::uint8_t { equal, fractionalEven, fractionalOdd };
    Domain domain = Domain::triangles;
    Spacing spacing = Spacing::equal;
    bool isClockwise = false;
    bool asPoints = false;
};

/// Vertices of the primitives that patches become: 1, 2 or 3.
constexpr int cornersOf(const TessellationLayout& layout) {
    if (layout.asPoints) return 1;
    return layout.domain == TessellationLayout::Domain::isolines ? 2 : 3;
}

}  // namespace glibra::base
