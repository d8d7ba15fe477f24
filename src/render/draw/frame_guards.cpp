// Keeps draws and dispatches from taking the device for long: they are cut into parts (work_share.h), and
// loops that the driver, or a guard, ends are recorded.

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "glsl/es/additions.h"
#include "gpu/object/readback.h"
#include "plan/accesses.h"
#include "render/draw/frame.h"
#include "render/load/derived_program.h"

namespace glibra::render {
namespace {

/// True if a stage has a loop, which alone can take seconds.
bool hasLoop(const BuiltProgram& built) {
    for (const glsl::TranslatedStage& stage : built.interface.facts.stages)
        for (const std::string_view word : {"for", "while"})
            for (std::size_t at = stage.source.find(word); at != std::string::npos;
                 at = stage.source.find(word, at + 1)) {
                const std::size_t next = stage.source.find_first_not_of(' ', at + word.size());
                if (next != std::string::npos && stage.source[next] == '(') return true;
            }
    return false;
}

}  // namespace

bool FrameDrawer::mayTakeLong(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    if (timeShare_ <= 0 || isCounted_ || hook_ ||
        plan::writesMemory(plan_.programs[planned.program], planned.textures))
        return false;
    const auto [known, isNew] = loops_.try_emplace(&built, false);
    if (isNew) known->second = hasLoop(built);
    return known->second;
}

int FrameDrawer::workInShares(const BuiltProgram& built, int rows, double pixels,
                              const std::function<void(int first, int end)>& work) {
    // Programs that have been quick are not waited for again.
    double& perPixel = device_.secondsPerPixel(&built);
    if (timeShare_ <= 0 || isCounted_ || (perPixel > 0 && perPixel * pixels < kQuickShare * timeShare_)) {
        work(0, rows);
        return 1;
    }
    using Clock = std::chrono::steady_clock;
    glFinish();
    Clock::time_point last = Clock::now();
    const Shares shares = doInShares(rows, timeShare_, work, [&last] {
        glFinish();
        const Clock::time_point now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(last, now)).count();
    });
    if (pixels > 0) perPixel = shares.seconds / pixels;
    return shares.parts;
}

void FrameDrawer::submitInReverse(const plan::PlannedDraw& planned) {
    constexpr int kParts = 8;  // along each side
    const gpu::PixelRectangle all = raster_.drawnPixels();
    const auto edge = [](int side, int part) { return side * part / kParts; };
    for (int row = kParts; row-- > 0;)
        for (int column = kParts; column-- > 0;) {
            const int left = edge(all.width, column), bottom = edge(all.height, row);
            const int width = edge(all.width, column + 1) - left, height = edge(all.height, row + 1) - bottom;
            if (width == 0 || height == 0) continue;
            raster_.narrowTo({all.x + left, all.y + bottom, width, height});
            submit(planned, true);
        }
    raster_.narrowTo(all);
}

void FrameDrawer::submitInShares(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    const auto stores = [](const glsl::TranslatedStage& each) { return each.facts.writesMemory; };
    const auto& stages = built.interface.facts.stages;
    // Every part runs the stages before the fragment stage again.
    if (programs_.isReversed() && std::ranges::count_if(stages, stores) == 1 &&
        stages.back().stage == glsl::Stage::fragment && stores(stages.back()))
        return submitInReverse(planned);
    if (!mayTakeLong(planned, built)) return submit(planned, true);
    const gpu::PixelRectangle all = raster_.drawnPixels();
    const int parts =
        workInShares(built, all.height, static_cast<double>(all.width) * all.height, [&](int first, int end) {
            raster_.narrowTo({all.x, all.y + first, all.width, end - first});
            // Waiting has ended what was drawn before.
            context_.debugLog().setPlace(plan_.drawOf(planned).place);
            submit(planned, true);
        });
    raster_.narrowTo(all);
    if (parts > 1) stats_.add("parts of draws", static_cast<std::uint64_t>(parts));
}

Diagnostics FrameDrawer::dispatchInShares(
    const BuiltProgram& built, const GroupCounts& groups, std::size_t axis,
    const std::function<Diagnostics(std::uint64_t begin, std::uint64_t end)>& run) {
    if (groups.at(axis) > std::numeric_limits<int>::max()) return run(0, groups.at(axis));
    Diagnostics refused;
    double all = 1;
    for (const std::uint64_t each : groups) all *= static_cast<double>(each);
    const int parts = workInShares(built, static_cast<int>(groups.at(axis)), all, [&](int first, int end) {
        if (first == end || !refused.empty()) return;
        refused = run(static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(end));
    });
    if (parts > 1) stats_.add("parts of dispatches", static_cast<std::uint64_t>(parts));
    return refused;
}

// Draws and dispatches whose programs record which of their loops the driver, or a guard, ends
// (Frame::recordsLoops).

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
