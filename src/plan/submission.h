#pragma once
// Decides how the primitives of a draw are submitted, and checks that the program's stages accept them
// (language, 4.8).

#include <glibra/result.h>

#include <limits>
#include <optional>

#include "glsl/types/request.h"
#include "plan/frame_plan.h"

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

}  // namespace glibra::plan
