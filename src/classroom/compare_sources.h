#pragma once
// Compares the shader code of all submissions of a class with each other.

#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// Sets the fingerprints and pairs of a class, and names in each entry what was not compared. Code of the
/// reference and of `given` is left out, and so is what more than `common` submissions have (MOSS's -m): it
/// comes from a lecture or a book. 0: usualCommon().
void compareSources(Classroom& classroom, const std::vector<SourceFile>& given, std::size_t common);

/// A third of the class, but at least 4 and at most 10, as for MOSS.
std::size_t usualCommon(std::size_t submissions);

}  // namespace glibra::classroom
