#pragma once
// One scene to image files: the unit of work of `glibra render`, done alone or in a worker process.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "gpu/context.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/shared_parts.h"

namespace glibra::render {

struct Job {
    std::filesystem::path scene;
    std::filesystem::path output;  ///< file; "-" is standard output, as PNG
    RenderOptions options;
    int frames = 1;
    double framesPerSecond = 30;
    /// An animation may be divided among as many jobs, of which this is number `part`. They must run on the
    /// same machine, each in a process of its own. On a driver that draws on the processor, and for a scene
    /// whose frames do not show earlier ones, each draws its share of the frames; else part 0 draws all.
    int part = 0, parts = 1;
    bool explain = false;
    bool stats = false;
};

/// What became of it. `failed` says that the scene or its output is wrong; `diagnostics` say why.
struct JobResult {
    bool failed = false;
    Diagnostics diagnostics;  ///< of an animation those of no single frame
    /// Of an animation, by the number of its frame: what is seen there for the first time.
    std::map<int, Diagnostics> ofFrames;
    std::string explanation;  ///< --explain
    std::string statsJson;    ///< --stats
};

/// Draws and writes all frames, or those of its part. Encoding and writing of one frame overlap with drawing
/// the next; frames that cannot differ are drawn and encoded once and copied. Called with the number of
/// frames written so far, as soon as each is. `shared`: what earlier scenes have made, or null.
JobResult runJob(gpu::Context& context, const Job& job,
                 const std::function<void(int framesWritten)>& frameWritten, SharedParts* shared = nullptr);

/// A picture of one colour is legal, but seldom meant (draw-N02, with the reason if the plan has it: all
/// draws are out of sight); NaN and infinities never are (draw-W06). `isSearched` leaves NaN to checkNan's
/// search, which names the draws.
Diagnostics remarksOn(const image::Image& picture, const std::filesystem::path& scene,
                      const plan::FramePlan& plan, bool isSearched = false);

/// The file of frame `index`: "a/b.png" becomes "a/b_0007.png" if there are several; as many digits as the
/// last frame needs, at least four.
std::filesystem::path frameFile(const std::filesystem::path& output, int index, int frames);

}  // namespace glibra::render
