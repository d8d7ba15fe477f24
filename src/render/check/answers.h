#pragma once
// Answers the Expect statements of a scene (language, 12.9) from what was drawn.

#include <glibra/result.h>

#include <functional>
#include <optional>
#include <vector>

#include "render/check/object_content.h"
#include "scene/conditions.h"
#include "scene/nodes.h"

namespace glibra::render {

/// What the checks of a moment ask for.
struct CheckQuestions {
    Contents& contents;
    std::function<std::uint64_t()> primitives, samples;  ///< of the whole frame
    std::function<Result<scene::Answer>(const scene::Check& check)> condition;
};

/// Returns nothing if the check holds, else check-E01 with what was expected and what was found, or the
/// reason why it cannot be answered. Not for checks of the kind `error`.
std::optional<Diagnostic> answer(const scene::Check& check, const CheckQuestions& questions);

/// The diagnostics without those that Expect error asks for, and check-E01 for each that was not reported.
Diagnostics withoutExpected(const std::vector<scene::Check>& checks, Diagnostics diagnostics);

/// The same if these checks have no picture to look at. If no error is left, check-E02 for each of them.
Diagnostics withoutPicture(const std::vector<scene::Check>& checks, Diagnostics diagnostics);

/// check-N02 for each texel or element of a content that a Print asks for, up to 1000, and one that says how
/// many more there are.
Diagnostics printedElements(const scene::Print& print, const Content& content);

/// check-W01 for each Expect that has not run, or check-N01 if another time or value may make it run.
Diagnostics reportIdle(const std::vector<scene::IdleCheck>& checks);

}  // namespace glibra::render
