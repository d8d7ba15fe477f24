#pragma once
// The input of a translation: the sources of one program, what the scene says about it, and what the driver
// can do. The driver's facts are plain numbers, so that a translation needs no GL context.

#include <glibra/diagnostic.h>

#include <compare>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/stage.h"

namespace glibra::glsl {

// ---- Values that a scene gives the constants of its shaders (language, 12.1)

/// A constant of a program: a macro of this name, or the value of the `const` variable or `#define` of that
/// name which a shader has.
struct Constant {
    std::string name;
    std::string type;  ///< a scalar, vector or square matrix of GLSL; empty: as the shader declares it
    bool isBoolean = false;
    std::vector<double> components;  ///< finite; of a matrix by columns; none: the value has an error

    friend auto operator<=>(const Constant&, const Constant&) = default;
};

/// The value as GLSL writes it for that type: "4", "(-.5)", "uvec2(1u, 2u)". Floating-point numbers have as
/// few digits as give the same double. Without a type it is a number whose type is int if it is whole, a
/// bool, a floating-point vector or matrix. Nothing if the type has another number of components, if it is an
/// integer and a component is no integer of 32 bits, or if it is no type of a constant.
std::optional<std::string> textOf(const Constant& constant, std::string_view type);

/// "4", "2.5", "(1, 0, 0)", "true": for messages.
std::string valueText(const Constant& constant);

// ---- The sources and the driver

/// The source of one stage as read from its file. Messages name `path`.
struct StageSource {
    Stage stage = Stage::vertex;
    std::string path;
    std::string text;
};

/// A file that an #include names.
struct IncludedFile {
    std::string path;  ///< that messages name
    std::string text;
    std::string id{};  ///< tells texts of one path apart, in messages too; empty: the path does
};
/// Finds the file that `includingPath` includes as `name`; nothing if there is no such file.
using IncludeReader =
    std::function<std::optional<IncludedFile>(std::string_view name, std::string_view includingPath)>;

/// The kind of texture that a sampler reads.
enum class SamplerKind { sampler1D, sampler2D, sampler3D, samplerCube };

/// What the driver can do.
struct Target {
    int version = 450;                        ///< the #version to emit, core profile
    bool isEs = false;                        ///< `version` is one of GLSL ES
    bool lineDirectiveTakesFileName = false;  ///< GL_ARB_shading_language_include: #line N "file"
    int maxGeometryOutputVertices = 256;
    int maxGeometryTotalOutputComponents = 1024;
    std::function<bool(std::string_view)> hasExtension;  ///< null: none beyond the version's own
};

/// How a scene draws with a program.
struct DrawForms {
    int patchVertices = 3;          ///< 0: patches of several sizes
    bool areStrips = false;         ///< some are strips, fans or loops
    bool haveIndexBuffers = false;  ///< some take their indices from a buffer of the scene
    bool haveInstanceData = false;  ///< some have attributes that advance with instances
    bool haveBufferData = false;    ///< some have attributes from a buffer of the scene
    bool haveWideLines = false;     ///< some have a line width that the driver lacks
};

/// Everything that decides how one program is translated. A compute stage is a program of its own.
struct ProgramRequest {
    std::string name;  ///< the Program's name, for messages
    Place place;       ///< the scene line of the Program
    std::vector<StageSource> stages;
    std::vector<Constant> constants;    ///< each name once
    std::vector<Place> constantPlaces;  ///< where the scene gives them
    IncludeReader include;
    Target target;
    bool shim = true;  ///< false (--no-shim): only the #version and #include lines are translated
    /// Lights and materials of older GLSL (gl_LightSource and its kin) are uniform variables with GL's
    /// initial values; otherwise they are constants.
    bool hasLights = false;
    bool setsLights = false;  ///< the scene gives them values: no glsl-W04
    /// A program with a vertex stage gets a fragment stage that draws the colour which it gives.
    bool suppliesFragment = false;
    /// A fragment stage alone gets the vertex stage of the fixed pipeline.
    bool suppliesFixedVertex = false;
    /// Storage blocks and atomic counters are accepted: the scene can have buffers. A compute program always
    /// accepts them.
    bool acceptsStorage = false;
    /// A fragment stage gets a vertex stage that covers the whole target with one triangle, from gl_VertexID
    /// alone (3 vertices, or the 4 of `FullScreen`; no vertex inputs), if it has none or one that lacks the
    /// `vST` that it reads. The supplied stage gives the fragment stage `vST` and
    /// gl_TexCoord[0], if that reads them: 0..1 over the target, (0, 0) in the lower left corner.
    bool suppliesFullScreenVertex = false;
    bool flatColors = false;  ///< the command Flat: gl_FrontColor and its kin are interpolated flat
    int colorTargets = 1;     ///< gl_FragColor is copied to this many outputs
    /// The program draws a part of a larger picture. The last stage before rasterisation maps gl_Position.xy
    /// to xy * glibra_Tile.xy + glibra_Tile.zw * w, and glibra_TileOrigin (pixels) is added to
    /// gl_FragCoord.xy.
    bool tiled = false;
    /// A compute program whose groups run in several dispatches. Each group sees its own number and the
    /// number of all groups: glibra_FirstGroup (groups before the dispatch along each axis),
    /// glibra_FirstInvocation (the same in invocations) and glibra_GroupCount (all groups) are uniforms.
    bool inPieces = false;
    /// Records at run time what GLSL leaves undefined: TranslatedProgram::undefinedSites. Needs version 430.
    bool checksUndefined = false;
    /// Records at run time which loops the driver ends: TranslatedProgram::loopSites. Needs version 430.
    bool recordsLoops = false;
    /// The invocations of a compute program have their numbers in reverse, within the group and among the
    /// groups, so that they run in another order.
    bool reversesOrder = false;
    std::string geometryInput;             ///< from GeometryInput, a lower-case GLSL word, or empty
    std::string geometryOutput;            ///< from GeometryOutput, likewise
    int geometryVerticesOut = 0;           ///< 0: not given
    DrawForms draws{};                     ///< for GLSL ES
    bool suppliesMatrices = false;         ///< also by well-known names (builtins.h), as in modern scenes
    bool reportsGeometryConflicts = true;  ///< glsl-W16, where the shader's layouts say something else
    /// The kinds of texture that the scene ever binds to the unit that the tag names. It decides the type of
    /// a `uniform int u` that is used as a sampler.
    std::function<std::vector<SamplerKind>(std::string_view tag)> samplerKindsOfTag;
};

/// What decides how a program is written in GLSL ES, besides its text.
struct EsOptions {
    /// Textures that the program reads may have a border, which whoever draws says by the uniforms of
    /// glsl/es/additions.h.
    bool hasBorders = false;
    DrawForms draws{};
};

}  // namespace glibra::glsl
