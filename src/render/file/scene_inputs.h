#pragma once
// What the texts of a scene say without a context: the files that it reads, and how its animation is divided.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::render {

/// The files that the text of a shader includes, as far as they are found. Conditions are not evaluated, so
/// they may be more than a picture needs.
std::vector<std::filesystem::path> includedFiles(std::string_view text, const std::filesystem::path& file,
                                                 const scene::Scene& scene, const RenderOptions& options,
                                                 scene::FolderListings& listings);

/// What a picture of a scene reads.
struct ReadByScene {
    /// The scene, scripts that it includes, shaders with what they include, textures and models. They are
    /// sorted, each once. Of a scene with errors those that are known.
    std::vector<std::filesystem::path> files;
    bool changesWithTime = false;  ///< another time may read other files
    /// False if the picture needs so many steps that not all of them were looked at; they may read more
    /// files.
    bool isWhole = true;
};

/// The scene is interpreted with exactly these options: for the picture's time, for the times that its checks
/// ask for and, if a model or an included script may depend on them, for the steps before.
ReadByScene filesReadBy(const std::filesystem::path& scene, const RenderOptions& options);

// ---- Animations
// An animation as a whole: before it is divided among processes, and after.

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
