#pragma once

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace glibra::gpu {

/// Keeps the device at most kMost pieces of work behind this process. Thousands of pieces that are submitted
/// at once would keep it from others for as long as they all take.
class WorkQueue {
  public:
    static constexpr std::size_t kMost = 4;

    WorkQueue() = default;
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;
    ~WorkQueue() {
        for (const GLsync each : ends_)
            if (each != nullptr) glDeleteSync(each);
    }

    /// Call it after the commands of each piece. Waits for the piece that was submitted kMost pieces before.
    void endPiece() {
        const GLsync before = std::exchange(ends_.at(next_), glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
        next_ = (next_ + 1) % kMost;
        if (before == nullptr) return;
        glClientWaitSync(before, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
        glDeleteSync(before);
    }

  private:
    std::array<GLsync, kMost> ends_{};  ///< of the last pieces
    std::size_t next_ = 0;
};

}  // namespace glibra::gpu
