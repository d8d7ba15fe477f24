#pragma once
// How large every shape gets, in closed form and in 64 bits, to be checked before a mesh is made.

#include <cstdint>

namespace glibra::geometry {

/// Vertices stored, and triangles, segments or points drawn. Arguments as those of the shape's function;
/// counts of up to 2^20 each cannot overflow.
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

constexpr Counts boxCounts() {
    return {24, 12};
}
constexpr Counts wireBoxCounts() {
    return {8, 12};
}
constexpr Counts teapotCounts(std::int64_t cells = 16) {
    return detail::counted(32 * (cells + 1) * (cells + 1), 64 * cells * cells - 8 * cells);
}
constexpr Counts wireTeapotCounts() {
    return {2592, 4544};
}
constexpr Counts soccerballCounts(std::int64_t cuts = 8) {
    return detail::counted(90 * (cuts + 1) * (cuts + 2), 180 * cuts * cuts);
}

constexpr Counts sphereCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks - 1) + 2 * slices, 2 * slices * (stacks - 1));
}
constexpr Counts wireSphereCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks - 1) + 2 * slices, slices * (2 * stacks - 1));
}
constexpr Counts cylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1) + 4 * slices + 2, 2 * slices * stacks + 2 * slices);
}
constexpr Counts wireCylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1), slices * (2 * stacks + 1));
}
constexpr Counts coneCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * stacks + 3 * slices + 1, 2 * slices * stacks);
}
constexpr Counts wireConeCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * stacks + slices, 2 * slices * stacks);
}
constexpr Counts torusCounts(std::int64_t sides, std::int64_t rings) {
    return detail::counted((rings + 1) * (sides + 1), 2 * rings * sides);
}
constexpr Counts wireTorusCounts(std::int64_t sides, std::int64_t rings) {
    return torusCounts(sides, rings);
}
constexpr Counts diskXYCounts(std::int64_t slices, std::int64_t rings) {
    return detail::counted((slices + 1) * rings + slices, slices * (2 * rings - 1));
}
/// Of quadXY, quadXZ and quadYZ.
constexpr Counts quadCounts(std::int64_t n1, std::int64_t n2) {
    return detail::counted((n1 + 1) * (n2 + 1), 2 * n1 * n2);
}
constexpr Counts quadBoxCounts(std::int64_t n) {
    return detail::counted(4 * n, 2 * n);
}
constexpr Counts xarrowCounts(std::int64_t slices, std::int64_t sides = 24) {
    return detail::counted((sides + 1) * slices + 6 * sides + 4, 2 * sides * (slices + 1));
}
/// Of pointCloud and jitterCloud.
constexpr Counts cloudCounts(std::int64_t nx, std::int64_t ny, std::int64_t nz) {
    return detail::counted(nx * ny * nz, nx * ny * nz);
}

}  // namespace glibra::geometry
