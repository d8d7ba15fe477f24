#pragma once
// How long the device works: measured by timer queries that are read when they are ready, and limited.

#include <glad/gl.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

/// Counts what the device does between begin() and end(): GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
/// GL_TIME_ELAPSED (nanoseconds) and so on. Only one query of a kind can run at a time. On llvmpipe
/// GL_TIME_ELAPSED measures the rasteriser's threads, which start when drawing is flushed.
class Query {
  public:
    explicit Query(GLenum kind) : kind_(kind) {}
    void begin() const { glBeginQuery(kind_, name_.get()); }
    void end() const { glEndQuery(kind_); }
    [[nodiscard]] bool isReady() const {
        GLint ready = GL_FALSE;
        glGetQueryObjectiv(name_.get(), GL_QUERY_RESULT_AVAILABLE, &ready);
        return ready != GL_FALSE;
    }
    /// The count between the last begin() and end(); waits for the device.
    [[nodiscard]] std::uint64_t result() const {
        GLuint64 count = 0;
        glGetQueryObjectui64v(name_.get(), GL_QUERY_RESULT, &count);
        return count;
    }

  private:
    GLenum kind_;
    Name<glDeleteQueries> name_{glGenQueries};
};

/// The GPU time of a piece is what the device's clock counts from the end of all work before it until the end
/// of its own. Pieces may contain others. What the driver does on the processor counts only where the device
/// has to wait for it. On a software driver the processor is the device; there each piece is flushed, because
/// llvmpipe would draw it later together with others. The calls of the timer are not among those that
/// CallCounter counts.
class Timer {
  public:
    /// Called for each piece that is measured, in the order of their ends.
    using Take = std::function<void(std::size_t piece, double milliseconds)>;

    Timer(const Capabilities& capabilities, Take take);

    /// False if the driver has no timer. Then nothing is measured.
    [[nodiscard]] bool measures() const { return bits_ > 0; }
    void begin(std::size_t piece);
    /// Ends the piece that was begun last.
    void end();
    /// Takes the pieces that are ready. Does not wait for the device.
    void collect();
    /// Takes all pieces that have ended; waits for the device.
    void finish();

  private:
    using QueryName = Name<glDeleteQueries>;
    struct Piece {
        std::size_t piece = 0;
        QueryName begin, end;
    };
    static constexpr std::size_t kMostPending = 1024;

    QueryName stamp();
    void takeFirst();

    int bits_;
    bool flushes_;
    Take take_;
    std::vector<Piece> open_;
    std::deque<Piece> pending_;  ///< ended; at most kMostPending
    std::vector<QueryName> free_;
};

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
