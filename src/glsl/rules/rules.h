#pragma once
// The rules of the language, section 7, each in a file of its own. They read the units and change their
// variables, renames, edits and prologues; the order in which `translate` calls them matters where it says
// so.

#include "glsl/parse/unit.h"
#include "glsl/parse/walk.h"

namespace glibra::glsl {

/// 7.4: attribute and varying become in and out; gl_VerticesIn as a size goes.
void modernizeQualifiers(ProgramUnits& program);
/// 7.4: names that 4.50 or the translation takes.
void renameTakenWords(ProgramUnits& program);
/// 7.2, 7.10, 7.12: what cannot be emulated, what the target is too old for, reserved prefixes, storage
/// buffers.
void refuse(ProgramUnits& program);
/// 7.9: subroutine uniforms become calls of the first function.
void resolveSubroutines(Unit& unit, Report& report);
/// 7.9: int uniforms used as textures become samplers.
void retypeSamplers(ProgramUnits& program);
/// 7.5: function names of older versions, noise functions.
void modernizeFunctions(Unit& unit, const TokenWalk& walk);
/// Section 6: matrices, inputs, Timer, noise textures.
void supplyBuiltins(ProgramUnits& program);
/// 7.6: lights, materials, fog, limits.
void supplyFixedState(Unit& unit, Report& report);
/// 7.6: colours, texture coordinates and fog between stages.
void connectBuiltinVaryings(ProgramUnits& program, const std::vector<TokenWalk>& walks);
/// ProgramRequest::tiled. Before connectBuiltinVaryings, whose EmitVertex calls the one from here.
void placeInTile(ProgramUnits& program);
/// 7.6: what the fragment stage writes.
void placeFragmentOutputs(ProgramUnits& program);
/// 7.7: names of EXT_geometry_shader4.
void modernizeGeometry(Unit& unit, const TokenWalk& walk, Report& report);
/// 7.7: layouts of the geometry stage. After all its outputs are known.
void completeGeometryLayout(ProgramUnits& program);
/// What the runtime has to know of a program whose sources stay as they are.
void readFactsAsIs(ProgramUnits& program);
/// 7.8.
void checkTessellation(ProgramUnits& program);
/// Some drivers get the patches of one draw in several. gl_PrimitiveID of the tessellation stages, and of the
/// fragment stage right behind them, is then larger by glibra_FirstPatch, the number of patches in the
/// earlier ones; gl_PrimitiveIDIn of the geometry stage by glibra_FirstPrimitive, the primitives that it got
/// from those.
void countPatchesInWhole(ProgramUnits& program);
/// 7.9: the user's own interfaces between stages.
void connectStages(ProgramUnits& program);
/// 7.10: W09, W10, W20, W21, W22.
void repairDeclarations(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report);

/// How the program places its vertices. After the variables' types and storages are known.
Placement findPlacement(const ProgramUnits& program);
/// TranslatedProgram::isOpaque. After placeFragmentOutputs.
bool findOpacity(const ProgramUnits& program);

/// Vertices of a geometry stage's input primitive.
int verticesOfPrimitive(std::string_view primitive);

/// 7.10, W23. After all edits of expressions.
void widenScalars(Unit& unit, Report& report);
/// 7.10: what targets below 4.20 and 4.30 do not take.
void adaptToTarget(Unit& unit);
/// Writes `renames` into the edits. Last.
void applyRenames(Unit& unit, const TokenWalk& walk);

/// The core name of a texture function of an older version, or empty.
struct TextureFunction {
    std::string core;       ///< "textureProjLod"
    std::string sampler;    ///< "sampler2D": what the name says; empty if it says nothing
    bool shadow = false;    ///< the old function returned a vec4
    bool dropsLod = false;  ///< the second argument has no place in the core function
};
TextureFunction textureFunction(std::string_view name);
/// A texture function in any spelling.
bool isTextureFunction(std::string_view name);

/// Lines of GLSL that define glibra_noiseN for each N that `wanted` has (bit N - 1).
std::vector<std::string> noiseFunctions(unsigned wanted);

}  // namespace glibra::glsl
