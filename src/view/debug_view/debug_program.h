#pragma once
// Programs that show what the pipeline does: a scene's own stages, whose main is called from another main.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/program_resources.h"
#include "gpu/context/context.h"
#include "gpu/object/program.h"
#include "render/load/programs.h"
#include "view/debug_view/texels.h"

namespace glibra::view {

// Debug views show something of the pipeline in place of the picture: as numbers and as colours. The window
// offers them as "Show".

/// `picture` is no debug view. `normals` is the picture with normals as lines. The others show a number for
/// every pixel that something is drawn on. The scene's own stages decide which pixels these are, including
/// what its fragment stages discard. Alpha is 0 where nothing is drawn.
enum class DebugView {
    picture,
    normals,
    coordinates,  ///< texture coordinates s, t, p
    facing,       ///< red: 1 front, 0 back
    overdraw,     ///< red: fragments that passed the depth test, in drawing order
    layers,       ///< red: all fragments, without depth test
    depth,        ///< red: window depth 0..1; green: distance from the eye's plane, in units of eye space
};
inline constexpr int kDebugViewCount = 7;

/// "picture", "normals", "texture coordinates", "facing", "overdraw", "layers", "depth".
std::string_view nameOf(DebugView kind);

/// The range of the shown numbers, for the legend.
struct ValueRange {
    double lowest = 0, highest = 0;  ///< over all pixels that something is drawn on
    bool isEmpty = true;
};
ValueRange rangeOf(DebugView kind, const TexelImage& numbers);

/// The colour (red, green, blue) for a number of fragments: black for 0, then from blue to red, white from 8.
std::array<std::uint8_t, 3> colorOfCount(double count);

/// Opaque RGBA bytes, bottom row first. Texture coordinates: s is red and t is green; outside 0..1 their
/// fractions are shown and blue is added. Facing: front blue, back orange. Depth: white (nearest) to dark
/// (farthest), by the distance from the eye.
std::vector<std::uint8_t> colorsOf(DebugView kind, const TexelImage& numbers);

/// The numbers of one pixel as text: "s 0.25, t 0.5, p 0", "front", "3 fragments", "depth 0.98, 4.2 from the
/// eye", "nothing is drawn here". `rgba` points to its four numbers.
std::string wordsOf(DebugView kind, const float* rgba);

/// The stages that draw a scene in a debug view.
enum class DebugStages {
    numbers,      ///< the scene's stages; colour output 7 (kDebugOutput) gets the number
    normalLines,  ///< the scene's stages up to the tessellation, and lines along the normals (output 0)
    flatNormals   ///< the scene's stages; output 7 gets the direction that a surface faces, as a colour
};
/// The colour output for the number. No scene in a window uses it.
inline constexpr int kDebugOutput = 7;
/// Colour output `output` (up to kDebugOutput) is written to the bound picture; the others are discarded.
void writeOnly(int output);

struct DebugProgram {
    gpu::Program program;
    base::ActiveResources resources;

    /// Does nothing if the program has no such uniform.
    void set(std::string_view uniform, std::span<const double> values) const;
    /// Puts it in use. Every uniform, sampler and block gets its value in the program that this one was made
    /// from.
    void use(const render::BuiltProgram& from) const;
};

/// Inputs of the vertex stage that only debug programs have.
inline constexpr std::string_view kDebugPosition = "glibra_debugPosition";
inline constexpr std::string_view kDebugNormal = "glibra_debugNormal";
inline constexpr std::string_view kDebugCoordinates = "glibra_debugCoordinates";

/// Nothing if it cannot be made: for texture coordinates that a tessellation or geometry stage does not pass
/// on as vST, and for normal lines of primitives other than triangles. Fragments that the scene's fragment
/// stage discards stay discarded, and depths that it writes are kept, unless the driver does not link it with
/// the additions.
std::optional<DebugProgram> makeDebugProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                             DebugView kind, DebugStages stages);

/// Its stages before the fragment stage, with one that writes 1 to output 7 and discards nothing. Nothing if
/// the driver does not link it.
std::optional<DebugProgram> makeCoverageProgram(const gpu::Context& context,
                                                const render::BuiltProgram& built);

/// Links stages that read the inputs of the program: these keep their locations, so that its vertex arrays
/// fit. `captured`: outputs for transform feedback. Nothing if the driver does not link them.
using StageTexts = std::vector<std::pair<GLenum, std::string>>;
std::optional<gpu::Program> linkStages(const gpu::Capabilities& capabilities,
                                       const render::BuiltProgram& from, const StageTexts& texts,
                                       std::vector<std::string> captured = {});

/// Null if the program has no such stage.
const glsl::TranslatedStage* stageOf(const render::BuiltProgram& built, glsl::Stage stage);
/// True if that program has a tessellation or geometry stage.
bool hasStagesAfterVertices(const render::BuiltProgram& built);

}  // namespace glibra::view
