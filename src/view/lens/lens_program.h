#pragma once
// Programs that show what the pipeline does: a scene's own stages, whose main is called from another main.

#include <optional>
#include <span>

#include "base/program_resources.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "render/programs.h"
#include "view/lens/lens.h"

namespace glibra::view {

/// The stages with which a draw is drawn while a lens is on.
enum class LensStages {
    numbers,      ///< the scene's stages; colour output 7 (kLensOutput) gets the lens's number
    normalLines,  ///< the scene's stages up to the tessellation, and lines along the normals (output 0)
    flatNormals   ///< the scene's stages; output 7 gets the direction that a surface faces, as a colour
};
/// The colour output for the lens. No scene in a window uses it.
inline constexpr int kLensOutput = 7;

struct LensProgram {
    gpu::Program program;
    base::ActiveResources resources;

    /// Does nothing if the program has no such uniform.
    void set(std::string_view uniform, std::span<const double> values) const;
    /// Gives every uniform, sampler and block its value in the program that this one was made from.
    void copyUniforms(const render::BuiltProgram& from) const;
};

/// Inputs of the vertex stage that only lens programs have.
inline constexpr std::string_view kLensPosition = "glibra_lensPosition";
inline constexpr std::string_view kLensNormal = "glibra_lensNormal";
inline constexpr std::string_view kLensCoordinates = "glibra_lensCoordinates";

/// Nothing if it cannot be made: for texture coordinates that a tessellation or geometry stage does not pass
/// on as vST, and for normal lines of primitives other than triangles. Fragments that the scene's fragment
/// stage discards stay discarded, and depths that it writes are kept, unless the driver does not link it with
/// the additions.
std::optional<LensProgram> makeLensProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                           Lens lens, LensStages stages);

/// True if that program has a tessellation or geometry stage.
bool hasStagesBehindVertices(const render::BuiltProgram& built);
bool hasGeometryStage(const render::BuiltProgram& built);

}  // namespace glibra::view
