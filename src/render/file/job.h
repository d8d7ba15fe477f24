#pragma once
// One scene to image files: the unit of work of `glibra render`, done alone or in a worker process.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "image/file.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/load/shared_parts.h"

namespace glibra::render {

/// The options of `glibra render` that a job takes as they are.
struct JobOptions {
    int frames = 1;
    double framesPerSecond = 30;
    bool explain = false;
    bool trace = false;       ///< lists the GL calls of the last frame
    bool checkOrder = false;  ///< of the first frame
};

struct Job : JobOptions {
    std::filesystem::path scene;
    std::filesystem::path output;                 ///< file; "-" is standard output, as PNG
    image::NamedBy named = image::NamedBy::user;  ///< what becomes of links that have the names of pictures
    RenderOptions options;
    int written = 0;  ///< frames that an earlier job has already written to standard output
    /// An animation may be divided among `parts` jobs; this one is number `part`. The jobs must run on the
    /// same machine, each in its own process. Each draws its share of the frames if the driver draws on the
    /// processor and no frame depends on earlier ones; otherwise part 0 draws all.
    int part = 0, parts = 1;
    bool stats = false;
    /// The content of a texture or buffer, which goes into a file after each picture
    /// (RenderOptions::wantedObjects).
    struct Save {
        std::string object;
        std::filesystem::path file;
    };
    std::vector<Save> saves{};
    /// What the files become that the job writes, if they are moved to another place afterwards: names as
    /// `output` has them, without the number of a frame unless it is a film. Otherwise it is empty.
    std::vector<std::filesystem::path> targets{};
};

/// The outcome of a job. `failed`: the scene or its output has an error, which `diagnostics` name.
struct JobResult {
    bool failed = false;
    Diagnostics diagnostics;  ///< for an animation, those that belong to no single frame
    /// For an animation, the diagnostics that a frame is the first to have, by the frame's number.
    std::map<int, Diagnostics> ofFrames;
    std::string explanation;  ///< --explain, --trace
    std::string statsJson;    ///< --stats
};

/// Draws and writes all frames, or those of its part. Nothing is drawn if a file that it would write is one
/// that the scene reads: file-E13. Encoding and writing of one frame overlap with drawing
/// the next; frames that cannot differ are drawn and encoded once and copied. `frameWritten` is called after
/// each file with the number of frames written so far. `shared`: parts of earlier scenes, or null.
JobResult runJob(gpu::Context& context, const Job& job,
                 const std::function<void(int framesWritten)>& frameWritten, SharedParts* shared = nullptr);

/// Diagnostics of a finished picture: draw-N02 if it has only one colour, with the reason if all draws are
/// out of sight; draw-W06 if it holds NaN or infinity. With `isSearched` draw-W06 is left to the search of
/// checkNan, which names the draws.
Diagnostics remarksOn(const image::Image& picture, const std::filesystem::path& scene,
                      const plan::FramePlan& plan, bool isSearched = false);

/// The place of a file, to tell whether two names mean one file: absolute, without links in its folders. A
/// link at its end stays: writing replaces it.
std::filesystem::path filePlaceOf(const std::filesystem::path& file);

/// The file of frame `index`. With several frames "a/b.png" becomes "a/b_0007.png", with as many digits as
/// the last frame needs, at least four.
std::filesystem::path frameFile(const std::filesystem::path& output, int index, int frames);

}  // namespace glibra::render
