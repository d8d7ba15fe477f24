#pragma once
// GLSL dialects (1.10 to 4.60, core, compatibility, EXT_geometry_shader4, gstap names) to one core version.
// The language specification, section 7, is the contract. No GL here: the driver's facts come in as numbers.

#include <glibra/diagnostic.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/facts/counted_loop.h"

namespace glibra::glsl {

enum class Stage { vertex, tessControl, tessEvaluation, geometry, fragment };
inline constexpr int kStageCount = 5;

/// One stage's source as read from its file; `path` is used in messages.
struct StageSource {
    Stage stage = Stage::vertex;
    std::string path;
    std::string text;
};

/// What an #include finds, or nothing.
struct IncludedFile {
    std::string path;
    std::string text;
};
using IncludeReader =
    std::function<std::optional<IncludedFile>(std::string_view name, std::string_view includingPath)>;

/// The dimension a texture is bound with. `none` stands for "no texture command ever uses that unit".
enum class SamplerKind { sampler1D, sampler2D, sampler3D, samplerCube };

/// What the driver can do, as numbers, so that translation needs no context.
struct Target {
    int version = 450;                        ///< #version emitted, core profile
    bool lineDirectiveTakesFileName = false;  ///< GL_ARB_shading_language_include: #line N "file"
    int maxGeometryOutputVertices = 256;
    int maxGeometryTotalOutputComponents = 1024;
    std::function<bool(std::string_view)> hasExtension;  ///< null: none beyond the version's own
};

/// Everything that decides how one program is translated.
struct ProgramRequest {
    std::string name;  ///< the Program's name, for messages
    Place place;       ///< the scene line of Program
    std::vector<StageSource> stages;
    IncludeReader include;
    Target target;
    bool shim = true;         ///< false: --no-shim, only #version spelling and #include are handled
    bool flatColors = false;  ///< Flat: gl_FrontColor and its kin are interpolated flat
    int colorTargets = 1;     ///< gl_FragColor is copied to this many outputs
    /// The program draws a part of a larger picture: the last stage before rasterisation maps gl_Position.xy
    /// to xy * glibra_Tile.xy + glibra_Tile.zw * w, and gl_FragCoord.xy reads larger by glibra_TileOrigin
    /// (pixels).
    bool tiled = false;
    std::string geometryInput;    ///< from GeometryInput, plain lower-case GLSL word, or empty
    std::string geometryOutput;   ///< likewise
    int geometryVerticesOut = 0;  ///< 0: not given
    /// Kinds of texture the scene ever puts on the unit that the tag names; for `uniform int u` used as a
    /// sampler.
    std::function<std::vector<SamplerKind>(std::string_view tag)> samplerKindsOfTag;
};

/// Where each line of a translated source comes from. lines[i] belongs to line i+1 of the emitted text.
struct LineOrigin {
    int file = -1;  ///< index into `files`, -1: written by the translator
    int line = 0;   ///< the user's line, as #line directives count it
};
/// From column `emitted` of an emitted line on, the user's columns count from `user`.
struct ColumnShift {
    int emitted = 1;
    int user = 1;
};
struct LineMap {
    std::vector<std::string> files;
    std::vector<LineOrigin> lines;
    std::vector<std::vector<ColumnShift>> columns;  ///< one entry a line; empty: the columns are the user's
};

struct TranslatedStage {
    Stage stage = Stage::vertex;
    std::string source;  ///< complete text for glShaderSource
    LineMap lineMap;
    std::string path;                ///< the stage's own file
    std::vector<CountedLoop> loops;  ///< that main runs and that can be counted, those of its functions too
};

/// A uniform as declared in a source, whether or not the compiler keeps it.
struct DeclaredUniform {
    Place place;
    bool hasInitializer = false;
};

/// Where a program puts what it draws, as far as its text proves it. It then has no stages but vertex and
/// fragment, and no effects but on the picture.
enum class Placement {
    unknown,
    vertex,  ///< gl_Position is the model-view-projection times the vertex
    point    ///< ... times vec4(vertex.xyz, 1)
};

struct TranslatedProgram {
    std::vector<TranslatedStage> stages;  ///< empty if `diagnostics` has an error
    Diagnostics diagnostics;

    std::map<std::string, std::string> userNames;     ///< emitted name -> the user's, where they differ
    std::map<std::string, DeclaredUniform> uniforms;  ///< by the user's name, of all stages
    std::map<std::string, int>
        textureBindings;  ///< layout(binding = n) on samplers and images, by user's name
    std::map<std::string, Place> vertexInputs;  ///< the user's own `in` of the vertex stage
    bool writesPointSize = false;               ///< by the last stage before rasterisation
    int clipDistances = 0;                      ///< gl_ClipDistance elements that stage writes
    int patchVertices = 0;                      ///< layout(vertices = n) of the control stage; 0: none
    std::string
        geometryInput;  ///< the geometry stage's input primitive, plain GLSL word; empty: no such stage
    std::string
        geometryOutput;  ///< "points", "line_strip" or "triangle_strip" that it delivers; empty: likewise
    std::string tessellationOutput;  ///< "triangles", "lines" or "points" that the evaluation stage delivers
    int fragmentOutputs = 1;         ///< number of colour locations written
    Placement placement = Placement::unknown;
    bool isOpaque = false;  ///< the text proves that the only colour written always has 1 for alpha

    std::string name;  ///< of the Program, and its scene line: for the notes under compile errors
    Place place;
    /// Where the stages declare their inputs, outputs and uniforms, by the user's name: for link logs.
    std::map<std::string, std::vector<Place>> interfaceNames;
};

/// Translates all stages of one program together. The user's mistakes are diagnostics, never exceptions.
TranslatedProgram translate(const ProgramRequest& request);

/// A line of a translated source.
struct EmittedLine {
    int number = 0;  ///< in TranslatedStage::source, from 1
    std::string text;
};

/// The lines that a stage's translation made of the user's line at `place`, in order, blank ones and #line
/// directives left out.
std::vector<EmittedLine> emittedLines(const TranslatedStage& stage, const Place& place);

/// The driver's compile log in the user's terms (language, 7.12): user's file and line, user's names, id
/// glsl-E01. Understands the formats of Mesa, NVIDIA, AMD/ATI, Apple and glslang. Driver warnings become
/// warnings without id.
Diagnostics explainCompileLog(const TranslatedProgram& program, const TranslatedStage& stage,
                              std::string_view log);

/// The driver's link log, as glsl-E02 at the place of the program, naming files and lines where names allow
/// it.
Diagnostics explainLinkLog(const TranslatedProgram& program, std::string_view log, const Place& programPlace);

}  // namespace glibra::glsl
