// Draws and dispatches whose programs record which of their loops the driver, or a guard, ends
// (Frame::recordsLoops).

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <utility>

#include "glsl/es/loop_guards.h"
#include "gpu/object/readback.h"
#include "plan/accesses.h"
#include "render/draw/captured_outputs.h"
#include "render/draw/frame.h"
#include "render/load/derived_program.h"

namespace glibra::render {

namespace {

constexpr int kFirstRounds = 1024, kFewestRounds = 64, kGrowth = 8;
constexpr double kQuickSeconds = .5;  // of some pixels
constexpr double kFrameSeconds = .25;

/// The largest number in the first component of the target's pixels.
int largestIn(const gpu::Capabilities& capabilities, const gpu::Target& target) {
    const auto pixels = gpu::readPixels(capabilities, target.readable(), 0,
                                        {0, 0, target.width(), target.height()}, {1, gpu::TexelType::u8});
    return pixels && !pixels->empty() ? std::to_integer<int>(std::ranges::max(*pixels)) : 0;
}

}  // namespace

const BuiltProgram* FrameDrawer::loopCounterOf(plan::PlannedProgramIndex program, const BuiltProgram& built,
                                               const Frame& frame) const {
    const BuiltProgram* counter = built.loopCounter.get();
    const bool isWanted = frame.recordsLoops && !isCounted_ && !hook_ && !programs_.isReversed() &&
                          plan_.programs[program].hasOpenLoops;
    return isWanted && counter != nullptr && counter->record ? counter : nullptr;
}

void FrameDrawer::useCounter(const BuiltProgram& built) {
    const BuiltProgram& counter = *built.loopCounter;
    bindings_.use(*counter.program);
    copyUniforms(built, *counter.program, counter.interface);
    bindings_.bindBase(*counter.record, GL_SHADER_STORAGE_BUFFER, counter.recordBinding);
}

bool FrameDrawer::recordLoops(const plan::PlannedDraw& planned, const BuiltProgram& built, const Frame& frame,
                              const base::RasterState& raster) {
    if (programOf(planned) != ownProgramOf(planned) ||
        loopCounterOf(planned.program, built, frame) == nullptr)
        return false;
    const bool stores = plan::writesMemory(plan_.programs[planned.program], planned.textures);
    base::RasterState unseen = raster;
    unseen.write.fill({false, false, false, false});
    unseen.depthWrite = false;
    unseen.stencilFront.writeMask = unseen.stencilBack.writeMask = 0;
    useCounter(built);
    if (!stores) raster_.apply(unseen);
    submit(planned, true);
    bindings_.use(*built.program);
    if (!stores) raster_.apply(raster);
    return stores;
}

void FrameDrawer::tryLoops(const plan::PlannedDraw& planned, const BuiltProgram& built,
                           const PassInProgress& pass, const base::RasterState& raster) {
    using Clock = std::chrono::steady_clock;
    BuiltProgram::Tried& tried = built.tried;
    const int width = pass.target.width(), height = pass.target.height();
    const double pixels = static_cast<double>(width) * height;
    const bool isWanted = pass.frame.recordsLoops || pixels > 2 * tried.pixels;
    const bool isSeen = std::ranges::any_of(
        built.interface.uniforms, [](const auto& each) { return each.emittedName == glsl::kShowsCut; });
    if (!isWanted || !isSeen || isCounted_ || hook_) return setOwnUniform(built, glsl::kRounds, tried.rounds);
    if (!loopTarget_ || loopTarget_->width() != width || loopTarget_->height() != height)
        loopTarget_ =
            gpu::Target::window(context_.capabilities(), width, height, gpu::TexelFormat::rgba8).value;
    if (!loopTarget_) return;
    using base::BlendEquation, base::BlendFactor;
    constexpr base::BlendFunction kLargest{BlendFactor::one, BlendFactor::one, BlendEquation::max};
    base::RasterState seen = raster;
    seen.depthTest = seen.depthWrite = seen.stencilTest = seen.alphaToCoverage = false;
    seen.blendAll({true, kLargest, kLargest});
    seen.write = {};
    const auto begin = [&](const gpu::Target& target) {
        target.bind();
        raster_.targetBound(width, height);
    };
    begin(*loopTarget_);
    setOwnUniform(built, glsl::kShowsCut, 1);
    tried.pixels = pixels;
    tried.rounds = kFirstRounds;
    double seconds = 0;
    for (bool isAgain = false;;) {
        raster_.openForClears();
        loopTarget_->clearColor(0, {});
        raster_.apply(seen);
        setOwnUniform(built, glsl::kRounds, tried.rounds);
        glFinish();
        const Clock::time_point start = Clock::now();
        submit(planned, true);
        tried.site = largestIn(context_.capabilities(), *loopTarget_);
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (tried.site == 0) break;
        if (seconds < kQuickSeconds && tried.rounds < glsl::kMostRounds) {
            tried.rounds = std::min(kGrowth * tried.rounds, glsl::kMostRounds);
            continue;
        }
        // A driver may compile as it draws for the first time.
        if (std::exchange(isAgain, true)) break;
    }
    tried.rounds =
        tried.site == 0
            ? glsl::kMostRounds
            : static_cast<int>(std::clamp<double>(kFrameSeconds * tried.rounds / (glsl::kSampled * seconds),
                                                  kFewestRounds, glsl::kMostRounds));
    setOwnUniform(built, glsl::kShowsCut, 0);
    setOwnUniform(built, glsl::kRounds, tried.rounds);
    begin(pass.target);
    raster_.apply(raster);
}

}  // namespace glibra::render
