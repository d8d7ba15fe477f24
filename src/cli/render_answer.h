#pragma once
// The answer of a worker process of `glibra render`, as text for the pipe to its parent process.

#include <string>
#include <string_view>

#include "cli/commands.h"
#include "render/file/animation.h"

namespace glibra::cli {

/// The result of a scene, or of a part of its frames.
struct Answer {
    int status = kDone;
    render::AnimationRemarks remarks{};
    std::string explanation{};  ///< --explain
    std::string statsJson{};    ///< --stats
};

std::string pack(const Answer& answer);
/// Reads what pack() wrote.
Answer unpack(std::string_view packed);

}  // namespace glibra::cli
