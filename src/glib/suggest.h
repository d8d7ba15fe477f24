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
/// 0 edits for words of up to 2 bytes, 1 up to 5, 2 up to 9, else 3. Words of more than 64 bytes are near to
/// nothing.
std::string nearestName(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace glibra::glib
