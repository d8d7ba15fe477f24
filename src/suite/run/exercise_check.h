#pragma once
// Whether an exercise is solved: its picture is that of the solution, at every moment that its file names
// (suite/file/sweep.h).

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gpu/context/context.h"
#include "image/image.h"
#include "suite/file/sweep.h"

namespace glibra::suite {

/// Why a picture does not solve the exercise, as one phrase that does not give the solution away: "its
/// picture differs from the solution's in 12 % of the pixels, most at 210, 80". Empty if it does. Rounding
/// may differ: a few levels anywhere, and single pixels by more. With `has`, only that decides.
std::string whyUnsolved(const std::optional<ColorShare>& has, const image::Image& solution,
                        const image::Image& own);

/// Draws the scene and its solution, in the size of the solution, until the pictures differ. An exercise that
/// is not solved is check-E04, a solved one check-N03; errors of either scene are reported as they are.
/// Nothing if no file beside the scene names a solution. `drawn` is called after each picture.
Diagnostics checkExercise(gpu::Context& context, const std::filesystem::path& scene,
                          const RenderOptions& options, const std::function<void()>& drawn);

}  // namespace glibra::suite
