#pragma once
// The row of a primitive: everything that the program knows about a shape made from numbers alone.
//
// A shape's row stands at the end of its own .cpp file and is listed in primitive_table.cpp. The parser, the
// interpreter, the planner, --max-error, the reference and the tests read the rows; nothing else names a
// primitive.

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// The numbers of one shape in the order of its row's arguments.
using Numbers = std::span<const double>;

enum class ArgumentKind {
    number,  ///< any finite number
    size,  ///< a length; a negative one is read as its absolute value, and the shape draws nothing if it is 0
    count,  ///< an integer from `least` to `most`: how many cells or points there are along one direction
    seed,   ///< an integer from `least` to `most`, which counts modulo 2^32
};

/// For ShapeArgument::smooth: this count runs along straight lines. The shape itself does not need it, so it
/// is never lowered; what a program computes at the vertices may need it.
inline constexpr int kAsGiven = 0;

struct ShapeArgument {
    std::string_view name{};
    ArgumentKind kind = ArgumentKind::number;
    double byDefault = 0;
    double least = 0, most = 0;  ///< of counts and seeds
    int smooth = kAsGiven;  ///< of counts: the least with which light computed at the vertices looks smooth
    bool isFixed =
        false;  ///< no scene can state it: it always has its default, unless --max-error changes it
};

constexpr ShapeArgument numberArgument(std::string_view name, double byDefault) {
    return {.name = name, .byDefault = byDefault};
}
constexpr ShapeArgument sizeArgument(std::string_view name, double byDefault) {
    return {.name = name, .kind = ArgumentKind::size, .byDefault = byDefault};
}
constexpr ShapeArgument countArgument(std::string_view name, int byDefault, int least, int smooth = kAsGiven,
                                      int most = kMostSubdivisions) {
    return {.name = name,
            .kind = ArgumentKind::count,
            .byDefault = static_cast<double>(byDefault),
            .least = static_cast<double>(least),
            .most = static_cast<double>(most),
            .smooth = smooth};
}
/// A count that the language fixes. Fixed arguments come after all others.
constexpr ShapeArgument fixedCount(std::string_view name, int byDefault, int least, int smooth) {
    ShapeArgument argument = countArgument(name, byDefault, least, smooth);
    argument.isFixed = true;
    return argument;
}

/// Where a shape lies in model space: in the box, and no further from the box's centre than `radius`.
struct Extent {
    glm::dvec3 low{0.0}, high{0.0};
    double radius = std::numeric_limits<double>::infinity();
};

/// What places a shape.
enum class Space {
    model,  ///< ModelView and the projection
    sky,    ///< the same, with the eye at the origin, and behind all other shapes, whatever its size
    clip,   ///< nothing: the positions are clip coordinates
};

/// What the mesh of a surface must keep.
enum class Fidelity {
    shape,   ///< every point of the mesh lies near the surface
    pattern  ///< every point lies near the point of the surface that has its texture coordinates
};

/// The functions take complete numbers (see completeNumbers).
struct PrimitiveSpec {
    std::array<std::string_view, 2> names{};  ///< the command as the reference spells it; an alias or nothing
    std::span<const ShapeArgument> arguments{};
    std::string_view summary{};  ///< one line for the reference
    Topology topology = Topology::triangles;
    Space space = Space::model;
    Counts (*counts)(Numbers) = nullptr;
    Mesh (*make)(Numbers) = nullptr;
    bool isClosed = false;                ///< each edge has a triangle on both sides, bit for bit
    bool oneSizeForAll = false;           ///< a lone number stands for the first three arguments
    bool hasFaceIndex = false;            ///< the mesh has the attribute kFaceIndex
    const PrimitiveSpec* twin = nullptr;  ///< draws the same as lines; for lines: as triangles

    /// For surfaces whose counts --max-error may choose; null for shapes without counts (Box) and for those
    /// whose counts are what they show (wires, clouds, QuadBox). An upper bound of the distance between mesh
    /// and surface in model units, which does not rise with any count.
    double (*deviation)(Numbers, Fidelity) = nullptr;
    Extent (*extent)(Numbers) = nullptr;  ///< set if `deviation` is
};

/// All primitives, in the order of the reference.
std::span<const PrimitiveSpec* const> primitives();

/// The given numbers made valid: missing ones have their defaults, sizes are not negative, counts and seeds
/// are inside their limits.
std::vector<double> completeNumbers(const PrimitiveSpec& spec, Numbers given);

/// True if a size is 0: the shape draws nothing (language, 1.7).
bool drawsNothing(const PrimitiveSpec& spec, Numbers given);

/// The count at that index of complete numbers.
inline int countAt(Numbers numbers, std::size_t index) {
    return static_cast<int>(numbers[index]);
}

// How far meshes lie from curved surfaces: the formulas that several primitives share.
//
// Fidelity::shape: a chord of a circle of radius r that is cut into n parts lies r (1 - cos(pi/n)) inside it.
// Fidelity::pattern: on a triangle that spans ds, dt of the parameters, linear interpolation is off by no
// more than (ds^2 |P_ss| + 2 ds dt |P_st| + dt^2 |P_tt|) / 8 (Filip, Magedson, Markot: Surface algorithms
// using bounds on derivatives, Computer Aided Geometric Design 3, 1986, theorem 1). This is larger than the
// first where cells are twisted: the diagonals of a sphere's cells shear what is painted on them.

/// Slices of 10 degrees: diffuse light, a cosine, is off by (pi/18)^2 / 8 = 0.97/255 where it is
/// interpolated.
inline constexpr int kSmoothTurn = 36;

inline double chordDeviation(double radius, double slices) {
    return radius * (1 - std::cos(std::numbers::pi / slices));
}

/// For a sphere or a part of one. The cells span the angles `around` and `along`, radians. The quads are
/// planar; the planes of the row at the equator, or next to it, lie furthest inside, at least
/// radius cos(around/2) cos(along/2) from the centre.
inline double ballDeviation(double radius, double around, double along, Fidelity fidelity) {
    if (fidelity == Fidelity::shape) return radius * (1 - std::cos(around / 2) * std::cos(along / 2));
    // |P_ss| = cos f, |P_sf| = |sin f|, |P_ff| = 1 at the latitude f: the largest sum over f.
    const double square = around * around;
    return radius / 8 * (along * along + std::hypot(square, 2 * around * along));
}

/// For the side of a cone. The rows narrow toward the apex, which twists the cells.
inline double coneSideDeviation(double radius, double slices, double stacks, Fidelity fidelity) {
    const double around = 2 * std::numbers::pi / slices;
    return fidelity == Fidelity::shape ? chordDeviation(radius, slices)
                                       : radius / 8 * (around * around + 2 * around / stacks);
}

inline Extent boxExtent(const glm::dvec3& low, const glm::dvec3& high) {
    return {low, high, glm::length(high - low) / 2};
}
inline Extent ballExtent(double radius) {
    return {glm::dvec3(-radius), glm::dvec3(radius), radius};
}
/// For a cylinder or a cone on the plane y = 0.
inline Extent standingExtent(double radius, double height) {
    return boxExtent({-radius, 0, -radius}, {radius, height, radius});
}

}  // namespace glibra::geometry
