#pragma once
// Decides how the primitives of a draw are submitted, and checks that the program's stages accept them
// (language, 4.8).

#include <glibra/result.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glsl/types/request.h"
#include "plan/frame_plan.h"
#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

/// The word of the language: "points", "lines", "lines_adjacency", "triangles", "triangles_adjacency",
/// "patches".
std::string_view wordOf(geometry::Topology topology);

/// Returns how the draw is submitted with this program; null stands for the built-in program. Errors:
/// draw-E02 (the geometry stage expects another kind), draw-E03 (the patch size does not fit), draw-E04
/// (patches without an evaluation stage). Each message says what to write instead.
Result<Submission> submissionOf(const scene::Scene& scene, const scene::Draw& draw,
                                const scene::Program* program, const ProgramInterface& interface);

/// How all draws of a scene with that program are submitted. `widestLine`: of the driver, in pixels.
glsl::DrawForms drawFormsOf(const scene::Scene& scene, scene::ProgramIndex program,
                            double widestLine = std::numeric_limits<double>::infinity());

/// The adjacency that the shape's triangles get if they are submitted as `submitted`; nothing if the mesh
/// stays as it is.
std::optional<geometry::Topology> addedAdjacency(const scene::Shape& shape, geometry::Topology submitted);

/// True if the program writes gl_PointSize and draws points, but PointSizeMode is 0 (draw-W05).
bool ignoresPointSize(const scene::Draw& draw, const scene::Program* program,
                      const ProgramInterface& interface, const Submission& submission);

/// The file name of the program's stage as the scene writes it, without folders; empty without that stage.
std::string stageFileName(const scene::Scene& scene, const scene::Program& program, glsl::Stage stage);

// ---- Inputs
// Finds what feeds the vertex inputs of a program, and the attributes that meshes have for them.

/// The sources of all inputs of a program, in the order of ProgramInterface::inputs, for draws with one set
/// of attributes. Inputs read, in this order: what the set gives them by name; what the runtime supplies
/// (language, 6); where names are supplied what they say in books (glsl::wellKnownAttribute); the attribute
/// of a list that has the same name.
std::vector<InputSource> inputSources(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                      const ProgramInterface& interface);

/// The name of an input or output as the user wrote it.
std::string userNameOf(const ProgramInterface& interface, const std::string& name);

/// The attributes that the mesh of a shape may have, in the order of the constants of geometry.
std::vector<std::string> attributesOf(const scene::Shape& shape);

}  // namespace glibra::plan
