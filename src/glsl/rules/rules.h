#pragma once
// The translation rules (language, 7), each in a file of its own. They read the units and change their
// variables, renames, edits and prologues. Where the order of their calls matters, the comment of the rule
// says so.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Moves between the significant tokens of a stage. Preprocessor lines are passed over.
class TokenWalk {
  public:
    explicit TokenWalk(const Unit& unit)
        : unit_(unit),
          next_(unit.tokens.size(), kNone),
          previous_(unit.tokens.size(), kNone),
          matches_(matchBrackets(unit.tokens, kNone)) {
        std::uint32_t last = kNone;
        for (std::uint32_t i = 0; i < unit.tokens.size(); ++i) {
            const Token& token = unit.tokens[i];
            if (!isSignificant(token.kind) || token.directive) continue;
            previous_[i] = last;
            if (last != kNone) next_[last] = i;
            last = i;
        }
    }

    /// The significant token after or before `token`, or kNone.
    [[nodiscard]] std::uint32_t next(std::uint32_t token) const {
        return token == kNone ? kNone : next_[token];
    }
    [[nodiscard]] std::uint32_t previous(std::uint32_t token) const {
        return token == kNone ? kNone : previous_[token];
    }
    /// The matching bracket, or kNone.
    [[nodiscard]] std::uint32_t match(std::uint32_t token) const { return matches_[token]; }
    [[nodiscard]] std::string_view text(std::uint32_t token) const {
        return token == kNone ? std::string_view{} : unit_.tokens[token].text;
    }

  private:
    const Unit& unit_;
    std::vector<std::uint32_t> next_, previous_, matches_;
};

/// What the names of the shader's own overloads of built-in functions begin with.
inline constexpr std::string_view kOwnOverload = "glibra_own_";
/// Gives them these names, in GLSL ES 1.00 (language, 7.9). True if there are any: then the unit has to be
/// parsed again.
bool renameOwnOverloads(Unit& unit);

/// Replaces attribute and varying by in and out, and removes gl_VerticesIn as an array size (language, 7.4).
void modernizeQualifiers(ProgramUnits& program);
/// Renames the user's names that are keywords or functions of 4.50, or that the translation uses
/// (language, 7.4).
void renameTakenWords(ProgramUnits& program);
/// Reports what cannot be emulated, what needs a newer target, reserved prefixes, and storage buffers in
/// scenes without them
/// (language, 7.2, 7.10, 7.12).
void refuse(ProgramUnits& program);
/// Replaces subroutine uniforms by ints, and their calls by calls of a function that chooses (language, 7.9).
void resolveSubroutines(ProgramUnits& program);
/// Turns int and float uniforms that are used as textures into samplers (language, 7.9).
void retypeSamplers(ProgramUnits& program);
/// Declares gl_Position invariant in vertex stages of a known placement, so that two passes draw the same
/// depth on every driver, whatever else they compute and however they spell it (language, 7.5). Call it after
/// findPlacement. Positions that rest on well-known names stay as they are spelled.
void makePositionsInvariant(ProgramUnits& program);
/// Replaces functions of older versions and supplies the noise functions (language, 7.5).
void modernizeFunctions(Unit& unit, const TokenWalk& walk);
/// Declares the matrices, inputs, Timer and noise textures that the stages use (language, 6).
void supplyBuiltins(ProgramUnits& program);
/// Supplies lights, materials, fog and limits (language, 7.6).
void supplyFixedState(Unit& unit, Report& report);
/// Passes colours, texture coordinates and fog between stages (language, 7.6).
void connectBuiltinVaryings(ProgramUnits& program, const std::vector<TokenWalk>& walks);
/// Performs ProgramRequest::tiled. Call it before connectBuiltinVaryings, whose EmitVertex calls the one from
/// here.
void placeInTile(ProgramUnits& program);
/// Performs ProgramRequest::inPieces and reversesOrder.
void runInPieces(ProgramUnits& program);
/// Replaces gl_FragColor and gl_FragData, and assigns the locations of outputs (language, 7.6).
void placeFragmentOutputs(ProgramUnits& program);
/// Replaces the names of EXT_geometry_shader4 (language, 7.7).
void modernizeGeometry(Unit& unit, const TokenWalk& walk, Report& report);
/// Completes the layouts of the geometry stage (language, 7.7). Call it when all outputs of the stage are
/// known.
void completeGeometryLayout(ProgramUnits& program);
/// Finds what the runtime has to know about a program that is not translated (--no-shim).
void readFactsAsIs(ProgramUnits& program);
/// Checks the tessellation stages, and finds what the runtime has to know about them (language, 7.8).
void checkTessellation(ProgramUnits& program);
/// Makes primitives have the same numbers on all drivers (language, 7.8). With tessellation stages they are
/// those of the patches in all stages; where the driver gets the patches of one draw in several draws,
/// glibra_FirstPatch is the number of patches in the earlier ones. A fragment stage after a geometry stage
/// that writes no number gets that of the primitive that the geometry stage got.
void numberPrimitives(ProgramUnits& program);
/// Matches the user's own variables between stages (language, 7.9).
void connectStages(ProgramUnits& program);
/// Reports uniforms and uniform and storage blocks of one name that two stages declare differently.
void checkUniformTypes(ProgramUnits& program);
/// Repairs mistakes in declarations: glsl-W09, W10, W20, W21, W22 (language, 7.10).
void repairDeclarations(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report);

/// Gives variables that may be read before they have a value the value zero, and reports those that certainly
/// are: glsl-W28 (language, 7.13). Call it after connectStages.
void giveInitialValues(Unit& unit, Report& report);
/// Only the reports, for a stage that is not translated.
void reportUnassigned(const Unit& unit, Report& report);

/// The number of vertices of a geometry stage's input primitive.
int verticesOfPrimitive(std::string_view primitive);

/// Widens scalar arguments of functions that want vectors: glsl-W23 (language, 7.10). Call it after all other
/// edits of expressions.
void widenScalars(Unit& unit, Report& report);
/// Writes the conversions that choose among the overloads of the user's functions into their calls; an
/// ambiguous call is glsl-E17 (language, 7.9).
void chooseOverloads(Unit& unit, Report& report);
/// Limits the subscripts of shared variables in a compute stage. Call it when `renames` are complete.
void limitSharedSubscripts(Unit& unit, TranslatedProgram& result, Report& report);
/// The text of a vertex stage for ProgramRequest::suppliesFullScreenVertex, and for this fragment stage.
std::string fullScreenVertex(const Unit& fragment);
/// The text of a fragment stage for ProgramRequest::suppliesFragment, after this stage: its colour is
/// gl_FrontColor if the stage writes it, otherwise an output with `color` in its name, otherwise the current
/// colour.
std::string defaultFragment(const Unit& last);
/// "gl_FrontColor", the name of that output, or nothing for the current colour.
std::string suppliedColor(const Unit& last);
/// The text of a vertex stage for ProgramRequest::suppliesFixedVertex: what the fixed pipeline did without
/// light.
std::string fixedVertex(const Unit& fragment);
/// True if the fragment stage reads `vST`, which the vertex stage does not declare.
bool lacksPlace(const Unit& vertex, const Unit& fragment);
/// Rewrites what targets below 4.20, 4.30 and 4.40 do not accept (language, 7.10).
void adaptToTarget(Unit& unit);
/// Writes `renames` into the edits. Call it last.
void applyRenames(Unit& unit, const TokenWalk& walk);

/// Lets the stage record what is undefined where it happens (ProgramRequest::checksUndefined). Call it after
/// applyRenames.
void recordUndefined(Unit& unit, std::vector<UndefinedSite>& sites);

/// Performs ProgramRequest::recordsLoops. Call it after all rules that add code.
void recordCutLoops(ProgramUnits& program);

/// What a texture function of an older version becomes.
struct TextureFunction {
    std::string core;       ///< the core name, as "textureProjLod"; empty for other functions
    std::string sampler;    ///< the sampler that the old name states, as "sampler2D", or empty
    bool shadow = false;    ///< the old function returned a vec4
    bool dropsLod = false;  ///< the core function does not take the second argument
};
TextureFunction textureFunction(std::string_view name);
/// True for a texture function in any spelling.
bool isTextureFunction(std::string_view name);

/// Lines of GLSL that define glibra_noiseN for each N whose bit N - 1 is set in `wanted`.
std::vector<std::string> noiseFunctions(unsigned wanted);

}  // namespace glibra::glsl
