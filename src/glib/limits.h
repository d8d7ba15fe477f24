#pragma once
// Limits of a scene's text (language, 11). What a command's own numbers may be stands in its row of the
// command table.

#include <cstddef>

namespace glibra::glib {

inline constexpr std::size_t kLargestFile = 4U << 20U;   // bytes
inline constexpr std::size_t kLongestLine = 64U << 10U;  // bytes
inline constexpr std::size_t kMostStatements = 200'000;
inline constexpr std::size_t kMostPrograms = 256;
inline constexpr std::size_t kMostTags = 1024;  // of one Program
inline constexpr std::size_t kMostBracketValues = 4096;
inline constexpr std::size_t kMostTargets = 8;       // of one RenderToTexture
inline constexpr double kMostSubdivisions = 65'536;  // slices, stacks, sides, rings, nx, ny ...
inline constexpr double kMostVertices = 8'388'608;   // of one command
inline constexpr double kLargestTextureSide = 16'384;
inline constexpr double kLargestVolumeSide = 2048;
inline constexpr double kLargestTexture = 1U << 30U;  // bytes
inline constexpr int kHighestUnit = 127;

}  // namespace glibra::glib
