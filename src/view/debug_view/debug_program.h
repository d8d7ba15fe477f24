#pragma once
// Programs of debug views: a scene's own stages, with their main wrapped in one of ours.

#include <optional>
#include <span>

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/reflection.h"
#include "render/programs.h"
#include "view/debug_view/debug_view.h"

namespace glibra::view {

/// The stages that a draw is drawn with in a debug view.
enum class DebugStages {
    numbers,      ///< the scene's stages; colour output 7 (kDebugOutput) gets the number
    normalLines,  ///< the scene's stages up to the tessellation, then lines along the normals (output 0)
    flatNormals   ///< the scene's stages; output 7 gets the direction a surface faces, as a colour
};
/// No scene for a window writes to it, so that all it does write can be left aside.
inline constexpr int kDebugOutput = 7;

struct DebugProgram {
    gpu::Program program;
    gpu::ProgramInterface reflected;

    /// Does nothing if the program has no such uniform.
    void set(std::string_view uniform, std::span<const double> values) const;
    /// Gives every uniform, sampler and block the value it has in the program this was made from.
    void copyUniforms(const render::BuiltProgram& from) const;
};

/// Inputs of the vertex stage that only debug programs have.
inline constexpr std::string_view kDebugPosition = "glibra_debugPosition";
inline constexpr std::string_view kDebugNormal = "glibra_debugNormal";
inline constexpr std::string_view kDebugCoordinates = "glibra_debugCoordinates";

/// Nothing if it cannot be made: texture coordinates that a tessellation or geometry stage does not pass on
/// as vST, lines of what is no triangle. Fragments that the scene's fragment stage discards stay discarded,
/// and depths that it writes are kept, unless the driver does not link it with ours.
std::optional<DebugProgram> makeDebugProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                             DebugView kind, DebugStages stages);

/// True if that program has a tessellation or geometry stage.
bool hasStagesBehindVertices(const render::BuiltProgram& built);
bool hasGeometryStage(const render::BuiltProgram& built);

}  // namespace glibra::view
