#pragma once
// The most that one draw may have (language, 12.6), whether the scene or a buffer gives the number.

namespace glibra::scene {

inline constexpr int kMostInstances = 100'000'000;
inline constexpr int kMostVertices = 500'000'000;

}  // namespace glibra::scene
