#pragma once
// The stages of a program. Those of the graphics pipeline are in the order in which they run.

#include <array>
#include <cstddef>

namespace glibra::glsl {

enum class Stage { vertex, tessControl, tessEvaluation, geometry, fragment, compute };
inline constexpr int kStageCount = 6;

/// "vertex", "tessellation control", ...
constexpr const char* stageName(Stage stage) {
    constexpr std::array<const char*, kStageCount> kNames{
        "vertex", "tessellation control", "tessellation evaluation", "geometry", "fragment", "compute"};
    return kNames.at(static_cast<std::size_t>(stage));
}

}  // namespace glibra::glsl
