#include "geometry/shapes/revolution.h"

#include <glm/geometric.hpp>

#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

/// Interpolates; exact at both ends.
double interpolated(double from, double to, double part) {
    return (1 - part) * from + part * to;
}

glm::dvec3 outward(const Axis& axis, const glm::dvec2& circle) {
    return axis.zero * circle.x + axis.quarter * circle.y;
}

SurfacePoint capPoint(const Axis& axis, const Cap& cap, double radius, double part,
                      const glm::dvec2& circle) {
    const glm::dvec3 place = part * outward(axis, circle);
    return {.position = ringPoint(axis, cap.along, radius, circle),
            .normal = glm::cross(cap.sDirection, cap.tDirection),
            .tangent = cap.tDirection,
            .texCoord = {.5 + .5 * glm::dot(place, cap.sDirection), .5 + .5 * glm::dot(place, cap.tDirection),
                         0}};
}

}  // namespace

glm::dvec3 ringPoint(const Axis& axis, double along, double radius, const glm::dvec2& circle) {
    return axis.along * along + axis.zero * (radius * circle.x) + axis.quarter * (radius * circle.y);
}

void addBandPoints(Surface& surface, const Axis& axis, const Band& band, std::span<const glm::dvec2> circle) {
    const auto slices = static_cast<int>(circle.size()) - 1;
    // The direction of the profile as (along, outward); the normal is a quarter turn away. A profile without
    // length is treated as a cylinder's.
    const glm::dvec3 direction =
        unitOr({band.endAlong - band.startAlong, band.endRadius - band.startRadius, 0}, {1, 0, 0});
    const auto point = [&](double part, const glm::dvec2& around, double s) {
        const glm::dvec3 out = outward(axis, around);
        return SurfacePoint{
            .position = ringPoint(axis, interpolated(band.startAlong, band.endAlong, part),
                                  interpolated(band.startRadius, band.endRadius, part), around),
            .normal = direction.x * out - direction.y * axis.along,
            .tangent = direction.y * out + direction.x * axis.along,
            .texCoord = {s, interpolated(band.startT, band.endT, part), 0}};
    };
    const int rings = band.apex ? band.rows - 1 : band.rows;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= slices; ++i)
            surface.add(point(static_cast<double>(j) / band.rows, circle[static_cast<std::size_t>(i)],
                              static_cast<double>(i) / slices));
    if (band.apex)
        for (int i = 0; i < slices; ++i)
            surface.add(
                point(1, unitTurn(2 * std::int64_t{i} + 1, 2 * std::int64_t{slices}), (i + .5) / slices));
}

void addBandCells(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices) {
    const auto rows = static_cast<std::uint32_t>(band.rows) - (band.apex ? 1 : 0);
    surface.gridCells(base, slices, rows);
    if (!band.apex) return;
    const std::uint32_t ring = base + rows * (slices + 1), apex = ring + slices + 1;
    for (std::uint32_t i = 0; i < slices; ++i) surface.triangle(ring + i, ring + i + 1, apex + i);
}

void addBandEdges(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices) {
    const auto rows = static_cast<std::uint32_t>(band.rows) - (band.apex ? 1 : 0);
    addGridEdges(surface, base, {.columns = slices, .rows = rows, .endRow = rows + 1, .endColumn = slices});
    if (!band.apex) return;
    const std::uint32_t ring = base + rows * (slices + 1), apex = ring + slices + 1;
    for (std::uint32_t i = 0; i < slices; ++i) surface.segment(ring + i, apex + i);
}

void addCap(Surface& surface, const Axis& axis, const Cap& cap, int rings,
            std::span<const glm::dvec2> circle) {
    const auto slices = static_cast<std::uint32_t>(circle.size() - 1);
    const std::uint32_t centre = surface.size(), firstRing = centre + slices;
    for (std::uint32_t i = 0; i < slices; ++i) surface.add(capPoint(axis, cap, 0, 0, circle[i]));
    for (int j = 1; j <= rings; ++j)
        for (const glm::dvec2& around : circle) {
            const double part = static_cast<double>(j) / rings;
            surface.add(capPoint(axis, cap, cap.radius * part, part, around));
        }
    const bool seenFromFront = glm::dot(glm::cross(cap.sDirection, cap.tDirection), axis.along) > 0;
    for (std::uint32_t i = 0; i < slices; ++i) {
        const std::uint32_t here = firstRing + i;
        if (seenFromFront)
            surface.triangle(centre + i, here, here + 1);
        else
            surface.triangle(centre + i, here + 1, here);
    }
    for (int j = 1; j < rings; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const std::uint32_t inner = firstRing + static_cast<std::uint32_t>(j - 1) * (slices + 1) + i;
            const std::uint32_t outer = inner + slices + 1;
            if (seenFromFront)
                surface.cell(inner, outer, outer + 1, inner + 1);
            else
                surface.cell(inner, inner + 1, outer + 1, outer);
        }
}

void addBackRing(Surface& surface, const Axis& axis, const Cap& cap, double innerRadius,
                 std::span<const glm::dvec2> circle) {
    const std::uint32_t base = surface.size();
    for (const glm::dvec2& around : circle)
        surface.add(capPoint(axis, cap, innerRadius, innerRadius / cap.radius, around));
    for (const glm::dvec2& around : circle) surface.add(capPoint(axis, cap, cap.radius, 1, around));
    surface.gridCells(base, static_cast<std::uint32_t>(circle.size()) - 1, 1);
}

}  // namespace glibra::geometry
