#pragma once
// What a stage runs: its code after the preprocessor, without what has no effect, as far as main reaches it.
// Copies are looked for in it, and rubrics ask what it calls: what is no part of it neither hides nor earns
// anything.

#include <string>
#include <vector>

#include "classroom/tokens.h"
#include "glsl/types/request.h"

namespace glibra::classroom {

struct ReachedCode {
    /// Code that stands together, in normal form. A function that nobody calls ends one and begins the next,
    /// and so does another file. `place` is empty.
    std::vector<SourceFile> runs;
    /// The functions and constructors that it calls, sorted, each once. A function of the text with the name
    /// of a built-in one, and as many parameters, is not the built-in one.
    std::vector<std::string> calls;
    bool isWhole = true;  ///< false: it is larger than what the preprocessor reads
};

/// Without a main, all functions count as reached. Code under conditions that ask for extensions is read as
/// drivers with and without them do.
ReachedCode reachedCode(const glsl::StageSource& stage, const glsl::IncludeReader& include = {});

}  // namespace glibra::classroom
