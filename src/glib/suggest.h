#pragma once
// "did you mean 'Sphere'?": the known name that lies nearest to an unknown one.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace glibra::glib {

/// Smallest number of insertions, deletions, replacements and exchanges of neighbouring bytes that turn `a`
/// into `b`, no byte edited twice (optimal string alignment distance); ASCII letters are compared without
/// regard to case.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate with the smallest distance, the first of several; empty if none is near. Near means at most
/// 0 edits for words of up to 2 bytes, 1 up to 5, 2 up to 9, else 3; the `prefix` first bytes, which say
/// nothing about the name like the u of a uniform's, are not counted for that. Words of more than 128 bytes
/// are near to nothing, and a name is not near to itself.
std::string nearestName(std::string_view word, std::span<const std::string_view> candidates,
                        std::size_t prefix = 0);

/// "; did you mean 'uShrink'?" with the nearest name, or nothing.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates,
                       std::size_t prefix = 0);

}  // namespace glibra::glib
