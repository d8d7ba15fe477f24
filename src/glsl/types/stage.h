#pragma once
// The stages of a program. Those of the graphics pipeline are in the order in which they run.

namespace glibra::glsl {

enum class Stage { vertex, tessControl, tessEvaluation, geometry, fragment, compute };
inline constexpr int kStageCount = 6;

}  // namespace glibra::glsl
