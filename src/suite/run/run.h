#pragma once
// Draws the shots of suites in worker processes and judges them there: pictures never travel through a pipe.
// A shot that crashes, hangs or exhausts memory costs only itself.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A shot of a list of suites.
struct ShotReference {
    std::size_t suite = 0, shot = 0;
    friend bool operator==(const ShotReference&, const ShotReference&) = default;
    friend bool operator<(const ShotReference& a, const ShotReference& b) {
        return std::tie(a.suite, a.shot) < std::tie(b.suite, b.shot);
    }
};

struct RunOptions {
    Driver driver = Driver::automatic;
    int jobs = 0;                     ///< worker processes; 0: defaultJobs()
    std::optional<double> timeout;    ///< seconds for every shot, instead of its own; 0: no limit
    bool update = false;              ///< what differs from its golden becomes it
    bool force = false;               ///< ... even pictures of one colour or with NaN
    bool skip = true;                 ///< false: what the pictures do not need is made and drawn all the same
    bool variant = false;             ///< ... for this family of drivers alone
    std::filesystem::path goldens{};  ///< folder with a folder a suite, instead of the suites' own
    std::filesystem::path results{};  ///< folder for the pictures of failures
    std::filesystem::path onlyRender{};  ///< if not empty: no goldens, pictures are written here by name
};

struct RunEvents {
    /// Called for each shot as it is done, in any order.
    std::function<void(const ShotResult&)> done;
    /// Called before a worker draws a shot.
    std::function<void(const ShotReference&)> begins;
    /// Asked now and then: once true, the run ends with the shots that are done.
    std::function<bool()> stop;
};

struct RunEnd {
    std::string driver;       ///< GL_RENDERER and GL_VERSION; empty if no shot was drawn
    Diagnostics diagnostics;  ///< of the run: goldens' side files, no driver (gpu-E01)
    bool noDriver = false;
    bool stopped = false;
};

/// Call it before any thread or GL context exists.
RunEnd runShots(std::span<const Suite> suites, std::span<const ShotReference> shots,
                const RunOptions& options, const RunEvents& events);

/// As many workers as there are processors: on llvmpipe processes beat threads.
int defaultJobs();
/// In a worker, before its context: divides the processors among the threads of the software rasterisers of
/// `jobs` workers, of which no more than `pieces` have work. A value that the user has set stays.
void shareProcessors(int jobs, std::size_t pieces);

/// The picture of a shot in a folder of rendered pictures.
std::filesystem::path pictureFile(const std::filesystem::path& folder, const Suite& suite, const Shot& shot,
                                  bool severalSuites);

}  // namespace glibra::suite
