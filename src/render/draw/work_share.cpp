#include "render/draw/work_share.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include "gpu/object/compute.h"
#include "plan/accesses.h"
#include "render/draw/frame.h"

namespace glibra::render {
namespace {

/// Rows that are done first, and show how long the others take, at these parts of the height: what is slow
/// need not cover the picture.
constexpr std::array<int, 3> kProbes{1, 3, 5};  // sixths
constexpr int kRowsOfProbe = 128;               ///< as a part of the height
constexpr int kFewestRows = 16;                 ///< of a draw that is cut
constexpr int kMostParts = 64;                  ///< that a draw is cut into because of what each costs

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

int doInShares(int rows, double share, const std::function<double(int first, int end)>& timed) {
    if (rows < kFewestRows) {
        timed(0, rows);
        return 1;
    }
    const double own = timed(0, 0);
    if (own > share) {  // what every part repeats is the longest of all
        timed(0, rows);
        return 1;
    }
    int parts = 0;
    double slowest = 0;  // seconds of a row
    const auto work = [&](int first, int end) {
        slowest = std::max(slowest, (timed(first, end) - own) / (end - first));
        ++parts;
    };
    const int probed = std::max(1, rows / kRowsOfProbe);
    int done = 0;
    std::array<std::array<int, 2>, kProbes.size() + 1> gaps{};
    for (std::size_t i = 0; i < kProbes.size(); ++i) {
        const int first = rows * kProbes.at(i) / 6;
        work(first, first + probed);
        gaps.at(i) = {done, first};
        done = first + probed;
    }
    gaps.back() = {done, rows};
    const int fewest = own > share / kMostParts ? std::max(1, rows / kMostParts) : 1;
    for (const auto& [begin, end] : gaps)
        for (int first = begin; first < end;) {
            const double fitting = slowest > 0 ? share / slowest : rows;
            const int count = static_cast<int>(std::clamp<double>(fitting, fewest, end - first));
            work(first, first + std::max(1, count));
            first += std::max(1, count);
        }
    return parts;
}

bool FrameDrawer::mayTakeLong(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    if (timeShare_ <= 0 || hook_ || plan::writesMemory(plan_.programs[planned.program], planned.textures))
        return false;
    const auto [known, isNew] = loops_.try_emplace(&built, false);
    if (isNew) known->second = hasLoop(built);
    return known->second;
}

int FrameDrawer::workInShares(const BuiltProgram& built, int rows, double pixels,
                              const std::function<void(int first, int end)>& work) {
    // Programs that have been quick are not waited for again.
    constexpr double kQuick = .25;
    double& perPixel = device_.secondsPerPixel(&built);
    if (timeShare_ <= 0 || (perPixel > 0 && perPixel * pixels < kQuick * timeShare_)) {
        work(0, rows);
        return 1;
    }
    using Clock = std::chrono::steady_clock;
    glFinish();
    const Clock::time_point start = Clock::now();
    const int parts = doInShares(rows, timeShare_, [&](int first, int end) {
        const Clock::time_point begun = Clock::now();
        work(first, end);
        glFinish();
        return std::chrono::duration<double>(Clock::now() - begun).count();
    });
    if (pixels > 0) perPixel = std::chrono::duration<double>(Clock::now() - start).count() / pixels;
    return parts;
}

void FrameDrawer::submitInShares(const plan::PlannedDraw& planned, const BuiltProgram& built) {
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
