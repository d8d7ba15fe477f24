#pragma once
// A program that shows something of the pipeline: a scene's own stages, their main wrapped in one of ours.

#include <optional>
#include <span>

#include "base/program_resources.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "render/programs.h"
#include "view/lens/lens.h"

namespace glibra::view {

/// What a draw is drawn with while a lens is on.
enum class LensStages {
    numbers,      ///< the scene's stages; color output 7 (kLensOutput) gets the lens's number
    normalLines,  ///< the scene's stages up to the tessellation, then lines along the normals (output 0)
    flatNormals   ///< the scene's stages; output 7 gets the direction a surface faces, as a colour
};
/// No scene for a window writes to it, so that all it does write can be left aside.
inline constexpr int kLensOutput = 7;

struct LensProgram {
    gpu::Program program;
    base::ActiveResources resources;

    /// Does nothing if the program has no such uniform.
    void set(std::string_view uniform, std::span<const double> values) const;
    /// Gives every uniform, sampler and block the value it has in the program this was made from.
    void copyUniforms(const render::BuiltProgram& from) const;
};

/// Inputs of the vertex stage that only lens programs have.
inline constexpr std::string_view kLensPosition = "glibra_lensPosition";
inline constexpr std::string_view kLensNormal = "glibra_lensNormal";
inline constexpr std::string_view kLensCoordinates = "glibra_lensCoordinates";

/// Nothing if it cannot be made: texture coordinates that a tessellation or geometry stage does not pass on
/// as vST, lines of what is no triangle. Fragments that the scene's fragment stage discards stay discarded,
/// and depths that it writes are kept, unless the driver does not link it with ours.
std::optional<LensProgram> makeLensProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                           Lens lens, LensStages stages);

/// True if that program has a tessellation or geometry stage.
bool hasStagesBehindVertices(const render::BuiltProgram& built);
bool hasGeometryStage(const render::BuiltProgram& built);

}  // namespace glibra::view
