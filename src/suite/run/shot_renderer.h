#pragma once
// Draws shots, and answers the process that runs them.

#include <glibra/diagnostic.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "gpu/context/context.h"
#include "render/load/shared_parts.h"
#include "render/scene_renderer.h"
#include "render/stats.h"
#include "suite/golden/golden_store.h"
#include "suite/run/run_options.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"

namespace glibra::suite {

// Work that runs beside the thread with the GL context.

/// Does jobs in order on a thread of its own. If a job throws, the jobs after it are done all the same, and
/// the next call of wait() or finish() throws the first exception.
class Background {
  public:
    Background() : thread_([this] { run(); }) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() { join(); }

    /// Adds a job and returns its number. Blocks while too many jobs wait, or while they hold too many bytes;
    /// `bytes` is what this one holds.
    std::uint64_t add(std::function<void()> job, std::size_t bytes = 0) {
        constexpr std::size_t kMostJobs = 16, kMostBytes = std::size_t{64} << 20U;
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] {
            return waiting_.empty() || (waiting_.size() < kMostJobs && bytes_ + bytes <= kMostBytes);
        });
        waiting_.push_back({std::move(job), bytes});
        bytes_ += bytes;
        changed_.notify_all();
        return ++added_;
    }
    /// Blocks until that job is done.
    void wait(std::uint64_t number) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return done_ >= number; });
        rethrow();
    }
    /// Blocks until all jobs are done.
    void wait() { wait(added_); }
    /// Does what is left and ends the thread. No job can be added afterwards.
    void finish() {
        join();
        rethrow();
    }

  private:
    struct Job {
        std::function<void()> work;
        std::size_t bytes = 0;
    };

    void join() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }

    void rethrow() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    void run() {
        while (true) {
            Job job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
                if (waiting_.empty()) return;
                job = std::move(waiting_.front());
                waiting_.pop_front();
                bytes_ -= job.bytes;
                changed_.notify_all();
            }
            std::exception_ptr failure;
            try {
                job.work();
            } catch (...) {
                failure = std::current_exception();
            }
            const std::scoped_lock lock(mutex_);
            if (!failure_) failure_ = failure;
            ++done_;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    std::size_t bytes_ = 0;  ///< held by the jobs that wait
    std::uint64_t added_ = 0, done_ = 0;
    std::exception_ptr failure_;  ///< the first that no caller has received yet
    bool closed_ = false;
    std::thread thread_;
};

// Renders shots with one context, one after another. What they share is made once. While one is drawn,
// another thread prepares the parts of the next ones that need no GL.

/// The largest number of shots that are prepared while one is drawn.
inline constexpr std::size_t kShotsAhead = 2;

class ShotRenderer {
  public:
    /// The context must outlive the object. `ofAll` is that of RunOptions. `awaits` is called before the
    /// renderer waits for another shot that is being prepared, and with null after it.
    explicit ShotRenderer(gpu::Context& context, Shot ofAll = {},
                          std::function<void(const Shot*)> awaits = {})
        : context_(context), ofAll_(std::move(ofAll)), awaits_(std::move(awaits)), shared_(std::in_place) {}

    /// Errors are in the result, including draw-E05 if memory runs out. `coming`, at most kShotsAhead shots,
    /// are prepared meanwhile for the calls that render them. The picture does not depend on them.
    Rendering render(const Shot& shot, std::span<const Shot* const> coming = {});
    /// Forgets everything, so that the next shot is loaded anew.
    void forget();

  private:
    /// What a shot is loaded from. Shots with the same source differ only in their time.
    struct Source {
        std::filesystem::path script;
        RenderOptions options;  ///< without the time
        friend bool operator==(const Source&, const Source&) = default;
    };
    struct Loaded {
        Source source;
        std::unique_ptr<render::Stats> stats;  ///< the renderer writes to it while it exists
        render::SceneRenderer renderer;
        Diagnostics diagnostics;
        /// The picture drawn last, if other times may give the same.
        std::optional<image::Image> picture;
        render::Moment moment;  ///< the moment of that picture
    };
    struct Preparation {
        const Shot* shot = nullptr;
        Source source;
        std::unique_ptr<render::Stats> stats;
        std::uint64_t job = 0;                       ///< of background_
        std::optional<render::PreparedScene> scene;  ///< once the job is done; nothing if that failed
    };

    [[nodiscard]] Source sourceOf(const Shot& shot) const;
    Rendering tryRender(const Shot& shot, std::span<const Shot* const> coming);
    Diagnostics load(const Source& source, std::span<const Shot* const> coming);
    void prepare(std::span<const Shot* const> coming, const Source& current);
    void beginPreparation(const Shot& shot, Source source);
    void dropPreparationsFrom(std::size_t first);
    Result<image::Image> draw(double time);

    gpu::Context& context_;
    Shot ofAll_;
    std::function<void(const Shot*)> awaits_;
    std::optional<render::SharedParts> shared_;
    std::optional<Loaded> loaded_;
    std::deque<Preparation> preparations_;  ///< in the order of the shots
    Background background_;  ///< last, because it must end before the objects that it works on are destroyed
};

// Reports uniform variables that a shot sets and its scene does not have.

/// Replaces each glib-W23 about a uniform of Shot::ownUniforms by suite-E19 with the place in the suite. A
/// sweep over a misspelt name would otherwise make equal pictures under different names and pass. Other
/// messages stay as they are.
void reportUnknownUniforms(const Shot& shot, Diagnostics& diagnostics);

// The work of one worker process. It keeps its GL context from piece to piece, and overlaps drawing a shot
// with judging the shots before it and preparing the shots after it.

/// What all workers of a run share. It outlives them.
struct RunPlan {
    std::span<const Suite> suites;
    std::vector<GoldenStore> goldens;  ///< one per suite; empty if the run only renders
    const RunOptions& options;
    std::vector<std::vector<ShotReference>> pieces;
    int jobs = 1;
    /// Drawings of a shot that ended their worker, or were late, and that `retries` forgive: the shot is
    /// drawn again, alone.
    struct Ended {
        int times = 0;
        ShotResult first;  ///< of the first of them
    };
    std::map<ShotReference, Ended> ended{};

    [[nodiscard]] const Shot& shotOf(const ShotReference& reference) const {
        return suites[reference.suite].shots[reference.shot];
    }
};

class ShotWorker {
  public:
    explicit ShotWorker(const RunPlan& plan) : plan_(plan) {}

    /// Does a piece and sends a message per step. The answer is empty, or says why there is no driver.
    std::string operator()(std::size_t piece, const base::Step& step);

  private:
    /// Opens the context. Returns nothing, or why there is none. `awaits`: see ShotRenderer.
    std::string openContext();
    /// `coming` are the shots that follow.
    Attempt attempt(const ShotReference& reference, std::span<const Shot* const> coming);
    /// The verdict; nothing if the shot has to be rendered once more, which `again` then holds.
    std::optional<Judged> judge(const ShotReference& reference, const Attempt& drawn,
                                const Attempt* again) const;
    /// How often a shot that fails may still be drawn again.
    [[nodiscard]] int retriesLeft(const ShotReference& reference) const;
    /// Writes the picture of a run that only renders.
    Judged keep(const ShotReference& reference, const Attempt& attempt) const;

    const RunPlan& plan_;
    std::optional<gpu::Context> context_;
    std::string driver_, driverKey_;
    std::function<void(const Shot*)> awaits_;  ///< during a piece: tells the parent what drawing waits for
    std::vector<ShotJudge> judges_;
    std::optional<ShotRenderer> renderer_;  ///< after the context, because it must be destroyed first
};

}  // namespace glibra::suite
