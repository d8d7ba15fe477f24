#pragma once
// An animation as a whole, before it is divided among processes and after.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace glibra::render {

/// What can be said of how many frames differ without a context, from the texts of the scene and its shaders
/// alone: that many at most, and never more than `most` (at least 1). 1 if no shader that is drawn with
/// speaks of Timer, or if the scene is wrong. The frames are `framesPerSecond` of them from options.time on.
int mostDifferentFrames(const std::filesystem::path& scene, const RenderOptions& options, int frames,
                        double framesPerSecond, int most);

/// What a remark is about: its id, and its place's file, line and column.
using Subject = std::tuple<std::string, std::string, int, int>;
Subject subjectOf(const Diagnostic& remark);

/// What is said of an animation, or of a part of it.
struct AnimationRemarks {
    Diagnostics general;                  ///< of no single frame
    std::map<int, Diagnostics> ofFrames;  ///< by the frame's number
};

/// The remarks of all parts as one process that draws all frames has them: of those about the same
/// subject the ones of the first frame, and none of a frame behind one with an error.
Diagnostics joined(const std::vector<AnimationRemarks>& parts);

}  // namespace glibra::render
