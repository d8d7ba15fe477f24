// Draws and dispatches that may take long are cut into parts (work_share.h).

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include "plan/accesses.h"
#include "render/draw/frame.h"
#include "render/draw/work_share.h"

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

}  // namespace glibra::render
