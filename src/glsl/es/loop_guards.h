#pragma once
// Loops of GLSL ES that end. A browser draws with one graphics process for all of its pages, which a loop
// without an end takes from them all. So the loops that the text does not prove short count their rounds:
// those of an invocation have kRounds rounds together, of which each counts the rounds of the short loops in
// it, too.

#include <cstdint>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

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
