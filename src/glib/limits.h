#pragma once
// Limits of a scene's text (language, 11). The limits of a statement's own numbers are in its row, those of a
// shape in its row in geometry/shapes.

#include <cstddef>

#include "geometry/mesh.h"

namespace glibra::glib {

inline constexpr std::size_t kLargestFile = 4U << 20U;   // bytes
inline constexpr std::size_t kLongestLine = 64U << 10U;  // bytes
inline constexpr std::size_t kMostStatements = 200'000;
inline constexpr std::size_t kMostPrograms = 256;
inline constexpr std::size_t kMostTags = 1024;  // per Program
inline constexpr std::size_t kMostBracketValues = 4096;
inline constexpr std::size_t kMostValues = 65'536;       // per modern statement
inline constexpr std::size_t kLongestExpression = 8192;  // bytes
inline constexpr std::size_t kDeepestParentheses = 128;  // in an expression
inline constexpr std::size_t kDeepestBlocks = 64;
inline constexpr std::size_t kMostTargets = 8;                    // per RenderToTexture
inline constexpr double kMostVertices = geometry::kMostVertices;  // per command
inline constexpr double kLargestTextureSide = 16'384;
inline constexpr double kLargestVolumeSide = 2048;
inline constexpr double kLargestTexture = 1U << 30U;  // bytes
inline constexpr int kHighestUnit = 127;

}  // namespace glibra::glib
