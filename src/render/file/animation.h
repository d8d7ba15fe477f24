#pragma once
// An animation as a whole: before it is divided among processes, and after.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace glibra::render {

/// An upper bound for the number of different frames, from the texts of the scene and its shaders alone,
/// without a context. It is 1 if no shader of a draw mentions Timer or if the scene has errors, and at most
/// `most` (at least 1). The frames start at options.time, with `framesPerSecond` per second.
int mostDifferentFrames(const std::filesystem::path& scene, const RenderOptions& options, int frames,
                        double framesPerSecond, int most);

/// What a diagnostic is about: its id, and its place's file, line and column.
using Subject = std::tuple<std::string, std::string, int, int>;
Subject subjectOf(const Diagnostic& remark);

/// The diagnostics of an animation, or of a part of it.
struct AnimationRemarks {
    Diagnostics general;                  ///< not of a single frame
    std::map<int, Diagnostics> ofFrames;  ///< by the frame's number
};

/// Joins the diagnostics of all parts into those of one process that draws all frames: for each subject those
/// of the first frame that has any, and none of a frame after one with an error.
Diagnostics joined(const std::vector<AnimationRemarks>& parts);

}  // namespace glibra::render
