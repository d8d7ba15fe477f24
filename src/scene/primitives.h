#pragma once
// Makes the mesh of a Shape (language, 3.3 and 4).

#include <glibra/result.h>

#include <cstdint>
#include <optional>

#include "geometry/mesh.h"
#include "glib/limits.h"
#include "scene/scene.h"

namespace glibra::scene {

/// The most vertices that one command, all commands of a scene, and one glBegin list may have (language, 11).
inline constexpr std::uint64_t kMostCommandVertices = geometry::kMostVertices;
inline constexpr std::uint64_t kMostSceneVertices = 67'108'864;
inline constexpr std::uint64_t kMostListVertices = 1'048'576;

/// The topology of the mesh that a command or a shape gives. Shp counts as lines, though its file may hold
/// points instead.
geometry::Topology topologyOf(glib::CommandId command);
geometry::Topology topologyOf(const Shape& shape);

/// True if the shape has a size of zero or is a list without a primitive: it draws nothing (language, 1.7).
bool drawsNothing(const Shape& shape);

/// The size of the mesh; nothing if a file decides it. A shape that draws nothing counts 0.
std::optional<geometry::Counts> countsOf(const Shape& shape);

/// Makes the mesh of Scene::shapes[shape] with all its attributes; a model gets tangents only on demand. A
/// shape that draws nothing gives a mesh without vertices. Models are read here. The messages about their
/// files (file-E01 ..., glib-E15 above kMostCommandVertices) are in the result and have the place of the
/// first statement that names the file. Returns draw-E05 if there is not enough memory.
Result<geometry::Mesh> makeMesh(const Scene& scene, ShapeIndex shape, bool withTangents = true);

}  // namespace glibra::scene
