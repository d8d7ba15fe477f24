#pragma once
// The size of a mesh, known in closed form and in 64 bits before the mesh is made.

#include <cstdint>

namespace glibra::geometry {

/// The most vertices that one command may have, and the most cells along one direction of a shape (language,
/// 11).
inline constexpr std::uint64_t kMostVertices = 8'388'608;
inline constexpr int kMostSubdivisions = 65'536;

/// The number of vertices stored, and of triangles, segments or points drawn. Each shape's header has the
/// function that gives them. Arguments of up to 2^20 cannot overflow.
struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t primitives = 0;

    friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

namespace detail {
constexpr Counts counted(std::int64_t vertices, std::int64_t primitives) {
    return {static_cast<std::uint64_t>(vertices), static_cast<std::uint64_t>(primitives)};
}
}  // namespace detail

}  // namespace glibra::geometry
