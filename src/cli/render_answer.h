#pragma once
// What a worker process of `glibra render` answers, as text for the pipe to the process that started it.

#include <string>
#include <string_view>

#include "cli/commands.h"
#include "render/animation.h"

namespace glibra::cli {

/// How a scene, or a part of its frames, went.
struct Answer {
    int status = kDone;
    render::AnimationRemarks remarks{};
    std::string explanation{};  ///< --explain
    std::string statsJson{};    ///< --stats
};

std::string pack(const Answer& answer);
/// The answer of that pack.
Answer unpack(std::string_view packed);

}  // namespace glibra::cli
