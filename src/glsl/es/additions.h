#pragma once
// What the stages of GLSL ES get in addition, with the uniforms that whoever draws gives values: borders of
// textures, quads in place of wide lines, and guards of loops.

#include <cstdint>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

// ---- Borders
// GLSL ES 3.00 has textures without borders: what lies outside is read by functions of the shader.

/// The uniform of the sampler `name` that says what its border is, an array of two vec4: 1 for each of s and
/// t that has one, 1 if depths compare as less, 1 for linear filters; then the colour.
inline constexpr const char* kBorderOf = "glibra_Border_";

/// Makes texture(), textureLod() and textureProj() read the borders of two-dimensional samplers; functions
/// with such parameters get the border as a further one. Of arrays of samplers no border is read, and near a
/// border no level but the first.
void passBorders(Unit& unit);

// ---- Wide lines
// Lines wider than the driver draws: the vertex stage makes quads of them, from the outputs that it has
// delivered for their ends before.

/// What the main function of the stage is called before widenLines() adds another one.
inline constexpr const char* kVertexMain = "glibra_vertexMain";

/// Adds a main function to the vertex stage of `stages`, which are GLSL ES: it calls kVertexMain, or makes
/// quads (WideLines). Returns nothing to capture if the program tells the strips that it emits, or if the
/// fragment stage reads structures, arrays whose size is not written as a number, or more than can be
/// captured; lines are then no wider than the driver draws them.
WideLines widenLines(std::vector<TranslatedStage>& stages, const ExpandedGeometry& expanded);

// ---- Guards of loops
// Loops of GLSL ES that end. A browser draws with one graphics process for all of its pages, which a loop
// without an end takes from them all. So the loops that the text does not prove short count their rounds:
// those of an invocation have kRounds rounds together, of which each counts the rounds of the short loops in
// it, too.

/// The uniform with the number of rounds. If kShowsCut is 1, all components of the first colour are the
/// number of the loop that was ended first, divided by 255: of the place in TranslatedProgram::loopSites,
/// from 1 on. 0: none was. One pixel of kSampled then runs its loops; those of the others end at once.
inline constexpr const char* kRounds = "glibra_Rounds";
inline constexpr const char* kShowsCut = "glibra_ShowsCut";
inline constexpr int kMostSites = 255, kSampled = 256;
/// Mesa's rasteriser ends a loop after 65,535 rounds itself, which no shader notices.
inline constexpr int kMostRounds = 60'000;
/// A loop of fewer rounds, together with those in it, is short if they are constant.
inline constexpr double kShortRounds = 4096;

/// Guards the loops of the stage. The numbers of the loops begin after `before`, and the variable `cut` gets
/// that of the first one that is ended. Returns the view indices of the loops.
std::vector<std::uint32_t> guardLoops(Unit& unit, std::string_view cut, std::size_t before);

}  // namespace glibra::glsl
