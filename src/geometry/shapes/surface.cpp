#include "geometry/shapes/surface.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <limits>
#include <utility>

#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

void write(std::vector<float>& values, std::size_t at, const glm::dvec3& v) {
    // + 0.0 turns -0 into 0, so that equal coordinates have equal bits.
    values[at] = static_cast<float>(v.x + 0.0);
    values[at + 1] = static_cast<float>(v.y + 0.0);
    values[at + 2] = static_cast<float>(v.z + 0.0);
}

}  // namespace

Surface::Surface(Topology topology, int texCoordComponents, const Counts& counts)
    : capacity_(static_cast<std::uint32_t>(counts.vertices)) {
    assert(counts.vertices <= std::numeric_limits<std::uint32_t>::max());
    mesh_.topology = topology;
    const auto vertices = static_cast<std::size_t>(counts.vertices);
    const auto texCoordSize = static_cast<std::size_t>(texCoordComponents);
    mesh_.attributes.push_back({std::string(kPosition), 3, std::vector<float>(3 * vertices)});
    mesh_.attributes.push_back({std::string(kNormal), 3, std::vector<float>(3 * vertices)});
    mesh_.attributes.push_back({std::string(kTangent), 3, std::vector<float>(3 * vertices)});
    mesh_.attributes.push_back(
        {std::string(kTexCoord), texCoordComponents, std::vector<float>(texCoordSize * vertices)});
    mesh_.indices.resize(static_cast<std::size_t>(counts.primitives) *
                         static_cast<std::size_t>(verticesPerPrimitive(topology)));
}

void Surface::add(const SurfacePoint& point) {
    assert(size_ < capacity_);
    const std::size_t at = std::size_t{3} * size_;
    write(mesh_.attributes[0].values, at, point.position);
    write(mesh_.attributes[1].values, at, point.normal);
    write(mesh_.attributes[2].values, at, point.tangent);
    Attribute& texCoord = mesh_.attributes[3];
    float* const values =
        texCoord.values.data() + std::size_t{size_} * static_cast<std::size_t>(texCoord.components);
    for (int c = 0; c < texCoord.components; ++c) values[c] = static_cast<float>(point.texCoord[c] + 0.0);
    ++size_;
}

void Surface::point(std::uint32_t a) {
    mesh_.indices[indexCount_++] = a;
}

void Surface::segment(std::uint32_t a, std::uint32_t b) {
    assert(indexCount_ + 2 <= mesh_.indices.size());
    mesh_.indices[indexCount_] = a;
    mesh_.indices[indexCount_ + 1] = b;
    indexCount_ += 2;
}

void Surface::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    assert(indexCount_ + 3 <= mesh_.indices.size());
    mesh_.indices[indexCount_] = a;
    mesh_.indices[indexCount_ + 1] = b;
    mesh_.indices[indexCount_ + 2] = c;
    indexCount_ += 3;
}

void Surface::cell(std::uint32_t a00, std::uint32_t a10, std::uint32_t a11, std::uint32_t a01) {
    triangle(a00, a10, a11);
    triangle(a00, a11, a01);
}

void Surface::gridCells(std::uint32_t base, std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t low = base + j * (columns + 1) + i;
            const std::uint32_t high = low + columns + 1;
            cell(low, low + 1, high + 1, high);
        }
}

Mesh Surface::finish() && {
    assert(size_ == capacity_ && indexCount_ == mesh_.indices.size());
    return std::move(mesh_);
}

void addGridEdges(Surface& surface, std::uint32_t base, const GridEdges& edges) {
    const std::uint32_t stride = edges.columns + 1;
    for (std::uint32_t j = 0; j <= edges.rows; ++j) {
        const std::uint32_t row = base + j * stride;
        if (j >= edges.firstRow && j < edges.endRow)
            for (std::uint32_t i = 0; i < edges.columns; ++i) surface.segment(row + i, row + i + 1);
        if (j < edges.rows)
            for (std::uint32_t i = 0; i < edges.endColumn; ++i) surface.segment(row + i, row + i + stride);
    }
}

namespace {

/// Interpolates; exact at both ends.
double interpolated(double from, double to, double part) {
    return (1 - part) * from + part * to;
}

glm::dvec3 outward(const Axis& axis, const glm::dvec2& circle) {
    return axis.zero * circle.x + axis.quarter * circle.y;
}

/// Returns the point of a ring. It has the same bits whatever surface it belongs to. `circle` is (cos, sin)
/// of 2 pi s.
glm::dvec3 ringPoint(const Axis& axis, double along, double radius, const glm::dvec2& circle) {
    return axis.along * along + axis.zero * (radius * circle.x) + axis.quarter * (radius * circle.y);
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

void addBandEdges(Surface& surface, const Band& band, std::uint32_t slices) {
    const auto rows = static_cast<std::uint32_t>(band.rows) - (band.apex ? 1 : 0);
    addGridEdges(surface, 0, {.columns = slices, .rows = rows, .endRow = rows + 1, .endColumn = slices});
    if (!band.apex) return;
    const std::uint32_t ring = rows * (slices + 1), apex = ring + slices + 1;
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
