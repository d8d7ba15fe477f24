#pragma once

#include <glad/gl.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>

namespace glibra::gpu {

/// Keeps the device at most kMost pieces of work behind this process, each of a few milliseconds. Thousands
/// of steps that are submitted at once would keep it from others for as long as they all take.
class WorkQueue {
  public:
    static constexpr std::size_t kMost = 4;
    static constexpr int kMostSteps = 1024;  ///< of a piece

    WorkQueue() = default;
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;
    ~WorkQueue() {
        for (const GLsync each : ends_)
            if (each != nullptr) glDeleteSync(each);
    }

    /// Call it after the commands of each step. Every few milliseconds it ends a piece, and waits for the one
    /// that was submitted kMost pieces before.
    void endStep() {
        if (++steps_ < stepsOfPiece_) return;
        steps_ = 0;
        const GLsync before = std::exchange(ends_.at(next_), glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
        next_ = (next_ + 1) % kMost;
        const Clock::time_point begun = std::exchange(last_, Clock::now());
        if (before == nullptr) return;
        glClientWaitSync(before, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
        glDeleteSync(before);
        // With kMost pieces behind, the time between two ends is what a piece takes the device, or this
        // process.
        last_ = Clock::now();
        const auto taken = last_ - begun;
        if (taken < std::chrono::milliseconds(1) && stepsOfPiece_ < kMostSteps) stepsOfPiece_ *= 2;
        if (taken > std::chrono::milliseconds(4) && stepsOfPiece_ > 1) stepsOfPiece_ /= 2;
    }

  private:
    using Clock = std::chrono::steady_clock;
    std::array<GLsync, kMost> ends_{};  ///< of the last pieces
    std::size_t next_ = 0;
    int steps_ = 0, stepsOfPiece_ = 1;
    Clock::time_point last_ = Clock::now();
};

}  // namespace glibra::gpu
