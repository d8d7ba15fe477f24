#include "geometry/shapes/surface.h"

#include <cassert>
#include <limits>
#include <utility>

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

}  // namespace glibra::geometry
