#include "geometry/shapes/box.h"

#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {

Mesh box(double dx, double dy, double dz) {
    assert(dx >= 0 && dy >= 0 && dz >= 0);
    struct Face {
        glm::dvec3 s, t;
    };
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const std::array<Face, 6> faces{{{-z, y}, {z, y}, {x, -z}, {x, z}, {x, y}, {-x, y}}};
    const glm::dvec3 half = glm::dvec3{dx, dy, dz} / 2.0;
    Surface surface(Topology::triangles, 2, boxCounts());
    for (const Face& face : faces) {
        const std::uint32_t base = surface.size();
        const glm::dvec3 normal = glm::cross(face.s, face.t);
        for (const double t : {0., 1.})
            for (const double s : {0., 1.})
                surface.add({.position = half * (normal + (2 * s - 1) * face.s + (2 * t - 1) * face.t),
                             .normal = normal,
                             .tangent = face.t,
                             .texCoord = {s, t, 0}});
        surface.gridCells(base, 1, 1);
    }
    return std::move(surface).finish();
}

Mesh skyBox(double side) {
    assert(side >= 0);
    Surface surface(Topology::triangles, 3, boxCounts());
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1., -1.}) {
            glm::dvec3 out{0}, s{0}, t{0};
            out[axis] = sign;
            s[(axis + 1) % 3] = 1;
            t[(axis + 2) % 3] = -sign;  // s x t points to the centre
            const std::uint32_t base = surface.size();
            for (const double b : {-1., 1.})
                for (const double a : {-1., 1.}) {
                    const glm::dvec3 direction = out + a * s + b * t;
                    surface.add({.position = side / 2 * direction,
                                 .normal = -out,
                                 .tangent = fallbackTangent(-out),
                                 .texCoord = direction});
                }
            surface.gridCells(base, 1, 1);
        }
    return std::move(surface).finish();
}

Mesh wireBox(double dx, double dy, double dz) {
    assert(dx >= 0 && dy >= 0 && dz >= 0);
    const glm::dvec3 half = glm::dvec3{dx, dy, dz} / 2.0;
    Surface surface(Topology::lines, 3, wireBoxCounts());
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place{corner & 1, corner >> 1 & 1, corner >> 2};
        const glm::dvec3 sign = 2.0 * place - 1.0;
        const glm::dvec3 normal = unitOr(half * sign, glm::normalize(sign));
        surface.add({.position = half * sign,
                     .normal = normal,
                     .tangent = fallbackTangent(normal),
                     .texCoord = place});
    }
    for (std::uint32_t bit = 1; bit < 8; bit *= 2)
        for (std::uint32_t corner = 0; corner < 8; ++corner)
            if ((corner & bit) == 0) surface.segment(corner, corner | bit);
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kSides[] = {sizeArgument("dx", 2), sizeArgument("dy", 2), sizeArgument("dz", 2)};
constexpr ShapeArgument kSide[] = {sizeArgument("side", 1)};
constexpr ShapeArgument kSkySide[] = {sizeArgument("side", 2)};

}  // namespace

constexpr PrimitiveSpec kBoxRow{.names = {"Box", "Cube"},
                                .arguments = kSides,
                                .summary = "box with these sides, centred",
                                .counts = [](Numbers) { return boxCounts(); },
                                .make = [](Numbers n) { return box(n[0], n[1], n[2]); },
                                .isClosed = true,
                                .oneSizeForAll = true,
                                .twin = &kWireBoxRow};

constexpr PrimitiveSpec kWireCubeRow{.names = {"WireCube"},
                                     .arguments = kSide,
                                     .summary = "edges of a cube",
                                     .topology = Topology::lines,
                                     .counts = [](Numbers) { return wireBoxCounts(); },
                                     .make = [](Numbers n) { return wireBox(n[0], n[0], n[0]); },
                                     .twin = &kBoxRow};

constexpr PrimitiveSpec kWireBoxRow{.names = {"WireBox"},
                                    .arguments = kSides,
                                    .summary = "edges of a box",
                                    .topology = Topology::lines,
                                    .counts = [](Numbers) { return wireBoxCounts(); },
                                    .make = [](Numbers n) { return wireBox(n[0], n[1], n[2]); },
                                    .twin = &kBoxRow};

constexpr PrimitiveSpec kSkyBoxRow{.names = {"SkyBox"},
                                   .arguments = kSkySide,
                                   .summary = "cube around the eye, seen from inside, behind everything",
                                   .space = Space::sky,
                                   .counts = [](Numbers) { return boxCounts(); },
                                   .make = [](Numbers n) { return skyBox(n[0]); },
                                   .isClosed = true};

}  // namespace glibra::geometry
