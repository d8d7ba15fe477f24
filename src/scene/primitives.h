#pragma once
// From a Shape to its mesh: one table row for each geometry command (language, 3.3 and 4).

#include <glibra/result.h>

#include <cstdint>
#include <optional>

#include "geometry/counts.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace glibra::scene {

/// Largest numbers of vertices: of one command, of all commands of a scene, of one glBegin list (language,
/// 11).
inline constexpr std::uint64_t kMostCommandVertices = 8'388'608;
inline constexpr std::uint64_t kMostSceneVertices = 67'108'864;
inline constexpr std::uint64_t kMostListVertices = 1'048'576;

/// True for a command that a shape with numbers alone comes from.
bool isPrimitive(glib::CommandId command);

/// Topology of the mesh that a command or a shape will give. Shp counts as lines: its file decides between
/// those and points.
geometry::Topology topologyOf(glib::CommandId command);
geometry::Topology topologyOf(const Shape& shape);

/// True for a shape of size zero and for a list without a primitive: it draws nothing (language, 1.7).
bool drawsNothing(const Shape& shape);

/// How large the mesh will be; nothing for shapes whose size a file decides. Shapes that draw nothing count
/// 0.
std::optional<geometry::Counts> countsOf(const Shape& shape);

/// Makes the mesh of Scene::shapes[shape], with all its attributes but, for models, tangents if they are not
/// wanted. What draws nothing gives a mesh without vertices. Models are read here; their files' remarks and
/// errors (file-E01 ..., glib-E15 beyond kMostCommandVertices) are in the result, at the place of the first
/// statement that names the file; draw-E05 if memory does not suffice.
Result<geometry::Mesh> makeMesh(const Scene& scene, ShapeIndex shape, bool withTangents = true);

}  // namespace glibra::scene
