#pragma once
// The answer of a worker process of `glibra render` or `glibra check`, as text for the pipe to its parent
// process.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/workers.h"
#include "cli/commands.h"
#include "render/check/scene_check.h"
#include "render/file/scene_inputs.h"
#include "suite/suite.h"

namespace glibra::cli {

/// The result of a scene, or of a part of its frames.
struct Answer {
    int status = kDone;
    render::AnimationRemarks remarks{};
    std::string explanation{};                        ///< --explain
    std::string statsJson{};                          ///< --stats
    std::vector<render::TranslatedShader> shaders{};  ///< of glibra check
    SourceLines lines{};                              ///< that the diagnostics quote on a terminal
};

std::string pack(const Answer& answer);

/// What a worker does, for messages: "drew" and "drawn".
struct Deed {
    std::string_view past, participle;
};

/// The worker's own answer, or the error that stands for one.
Answer answerOf(const base::Outcome& outcome, const std::string& scene, const suite::Shot& picture,
                const Deed& deed);

/// Calls `work`. If it throws, the answer is the error that stands for the exception; DeviceLost is passed
/// on.
Answer guarded(const std::string& scene, const std::function<Answer()>& work);

}  // namespace glibra::cli
