#pragma once
// What the stages say about themselves, read from their tokens. Each fact is a field of the translation's
// result (types/translated_program.h) and has a file of its own. A search that is not sure gives up rather
// than guesses.

#include <set>
#include <string>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Fills uniforms, textureBindings, vertexInputs and interfaceNames of the result.
void collectDeclarations(ProgramUnits& program);

/// Fills memory and localSize of the result.
void collectMemory(ProgramUnits& program);

/// TranslatedProgram::wholeWrites of a compute stage.
std::vector<WholeWrite> wholeWritesOf(const Unit& unit);

/// True if the stage names a storage block that is not readonly.
bool hasWritableStorage(const Unit& unit);

/// True if the stage may write memory: it names an image or a storage block that is not readonly, or an
/// atomic counter.
bool writesMemory(const Unit& unit);

/// TranslatedProgram::placement and placementNames. Call it after the rules have settled the types and
/// storages of all variables.
void findPlacement(const ProgramUnits& program);

/// TranslatedProgram::isOpaque. Call it after placeFragmentOutputs.
bool findOpacity(const ProgramUnits& program);

/// TranslatedProgram::levelUniforms. Call it after checkTessellation.
std::set<std::string> findLevelUniforms(const ProgramUnits& program);

/// What the code of a stage does. Call it after all rules, which may add flat inputs and retype samplers.
StageFacts factsOf(const Unit& unit);

/// True if a vertex stage names the tangent input.
bool mayReadTangents(const ProgramUnits& program);

/// The loops that main runs, also in the functions that it calls, and the vertices that it emits outside of
/// them. A call counts like the code of the function, if only one function has that name; otherwise the call
/// is a loop that cannot be counted, if the functions have any.
struct LoopFacts {
    std::vector<CountedLoop> loops;
    double emits = 0;                ///< TranslatedStage::emits
    std::vector<Place> uncounted{};  ///< TranslatedStage::uncounted
};
LoopFacts loopsOf(const Unit& unit);

/// Fills patchVerticesRead, maxVertices and invocationAxes of the result, with their places.
void collectReaches(ProgramUnits& program);

/// TranslatedStage::subscripts.
std::vector<ElementSubscript> subscriptsOf(const Unit& unit);

}  // namespace glibra::glsl
