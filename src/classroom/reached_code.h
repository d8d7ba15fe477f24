#pragma once
// What a stage runs: its code after the preprocessor, without what has no effect, as far as main reaches it.
// Copies are looked for in it, and rubrics ask what it calls: what is no part of it neither hides nor earns
// anything.

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "classroom/tokens.h"
#include "glsl/types/request.h"

namespace glibra::classroom {

struct ReachedCode {
    /// Each function, and of each file what is no function, in normal form. `place` is empty.
    std::vector<SourceFile> runs;
    /// Digests of its functions as they are written, but for names, numbers and what has no effect.
    std::vector<std::uint64_t> functions{};
    /// The functions and constructors that it calls, sorted, each once. A function of the text with the name
    /// of a built-in one, and as many parameters, is not the built-in one.
    std::vector<std::string> calls;
    bool isWhole = true;  ///< false: it is larger than what the preprocessor reads
};

/// Which functions are written out where they are called.
struct InlineRule {
    std::function<bool(const std::string& path)> isOwn{};  ///< those of these files; none: no function
    std::set<std::uint64_t> given{};  ///< but none of these (ReachedCode::functions): all have them
};

/// Without a main, all functions count as reached. Code under conditions that ask for extensions is read as
/// drivers with and without them do.
ReachedCode reachedCode(const glsl::StageSource& stage, const glsl::IncludeReader& include = {},
                        const InlineRule& rule = {});

}  // namespace glibra::classroom
