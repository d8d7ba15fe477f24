#pragma once
// How a draw's primitives enter the pipeline, and whether the program's stages go with them (language, 4.8).

#include <glibra/result.h>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// The language's word: "points", "lines", "lines_adjacency", "triangles", "triangles_adjacency", "patches".
std::string_view wordOf(geometry::Topology topology);

/// How the draw is submitted with this program. Errors: draw-E02 (the geometry stage wants another kind),
/// draw-E03 (the patch size does not fit), draw-E04 (patches without an evaluation stage), each with what to
/// write instead. `program` is null for the built-in program.
Result<Submission> submissionOf(const scene::Scene& scene, const scene::Draw& draw,
                                const scene::Program* program, const ProgramInterface& interface);

/// True if the program writes gl_PointSize, points reach the rasteriser, and the draw's mode is 0 (draw-W05).
bool ignoresPointSize(const scene::Draw& draw, const scene::Program* program,
                      const ProgramInterface& interface, const Submission& submission);

/// File name, without folders, of the program's stage, as the scene writes it; empty if there is none.
std::string stageFileName(const scene::Scene& scene, const scene::Program& program, glsl::Stage stage);

}  // namespace glibra::plan
