#pragma once
// What a picture cost: the time of each stage, counts of what was made and drawn, and what was skipped.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "budget/decision.h"
#include "plan/frame_plan.h"

namespace glibra::render {

// Names of counts.
inline constexpr std::string_view kDrawsOutOfTheirTile = "draws out of their tile";
/// Passes into textures, and dispatches, that were not repeated for a frame (plan::stillNodes).
inline constexpr std::string_view kStillPasses = "passes not repeated";
inline constexpr std::string_view kStillDispatches = "dispatches not repeated";

struct Stats {
    struct Stage {
        std::string name;
        double milliseconds = 0;
    };
    struct Count {
        std::string name;
        std::uint64_t value = 0;
    };
    /// How long the device worked at a pass, a dispatch or a clear, all its executions together.
    struct GpuTime {
        std::string what;  ///< "pass into window"
        int line = 0;      ///< of its statement; 0: none
        std::uint64_t times = 0;
        double milliseconds = 0;
    };
    std::vector<Stage> stages;  ///< in the order of first use
    std::vector<Count> counts;
    std::vector<plan::Skipped> skipped;
    std::vector<budget::Decision> decisions;  ///< of RenderOptions::maxError
    /// Uniforms and inputs that read a variable or a value by their name alone.
    std::vector<plan::Skipped> foundByName;
    /// In the order of first use. Nothing: it is not measured, because the driver has no timer, or nobody
    /// asked for it.
    std::optional<std::vector<GpuTime>> gpu;

    void addTime(std::string_view stage, double milliseconds);
    void add(std::string_view count, std::uint64_t value);
    void skip(std::string_view what, std::string why, const Place& place);
};

/// Adds the time of its own life to one stage.
class StageTimer {
  public:
    StageTimer(Stats& stats, std::string_view stage)
        : stats_(stats), stage_(stage), start_(std::chrono::steady_clock::now()) {}
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;
    ~StageTimer() {
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start_;
        stats_.addTime(stage_, taken.count());
    }

  private:
    Stats& stats_;
    std::string_view stage_;
    std::chrono::steady_clock::time_point start_;
};

/// For --stats: one JSON object that also holds the scene, the picture's size and the driver.
std::string toJson(const Stats& stats, std::string_view scene, int width, int height,
                   std::string_view driver);
/// For --explain: the same as text.
std::string toText(const Stats& stats);

}  // namespace glibra::render
