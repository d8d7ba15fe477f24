#pragma once
// Draws the shots of suites in worker processes and judges them there, so that pictures never travel through
// a pipe. A shot that crashes, hangs or runs out of memory affects only itself.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "base/sandbox.h"
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
    int jobs = 0;                         ///< worker processes; 0: gpu::usualWorkers()
    std::optional<double> timeout;        ///< seconds for every shot, instead of its own; 0: no limit
    std::optional<std::uint64_t> memory;  ///< bytes for every shot, instead of its own; 0: no limit
    bool update = false;                  ///< pictures that differ replace their goldens
    bool force = false;                   ///< ... even pictures of one colour or with NaN
    bool checkUndefined = false;          ///< RenderOptions::checkUndefined of all shots
    bool skip = true;                     ///< false: also makes and draws what the pictures do not need
    bool variant = false;                 ///< ... for this family of drivers alone
    bool also = false;                    ///< ... and are accepted beside them instead
    bool strictFlaky = false;             ///< flaky shots are unstable
    bool allowOutside = false;            ///< goldens may be links to places outside of their folder
    std::filesystem::path goldens{};      ///< folder with one folder per suite, instead of the suites' own
    std::filesystem::path results{};      ///< folder for the pictures of failures
    bool refusesMisspelt =
        false;  ///< with `onlyRender`: misspelt names are errors (render/check/misspellings.h)
    std::filesystem::path onlyRender{};      ///< if not empty: no goldens, pictures are written here by name
    const base::Sandbox* sandbox = nullptr;  ///< if given, what confines the workers; excludes `update`
};

struct RunEvents {
    /// Called for each shot as it is done, in any order.
    std::function<void(const ShotResult&)> done;
    /// Called before a worker draws a shot.
    std::function<void(const ShotReference&)> begins;
    /// Called regularly. Once it returns true, the run ends with the shots that are done.
    std::function<bool()> stop;
};

struct RunEnd {
    std::string driver;       ///< GL_RENDERER and GL_VERSION; empty if no shot was drawn
    Diagnostics diagnostics;  ///< of the run: hash lists, no driver (gpu-E01)
    bool noDriver = false;
    bool stopped = false;
};

/// Call it before any thread or GL context exists.
RunEnd runShots(std::span<const Suite> suites, std::span<const ShotReference> shots,
                const RunOptions& options, const RunEvents& events);

/// `wanted` workers that draw `pieces` scenes or shots; 0: as many as draw them soonest. Where the processor
/// draws, that is one per processor, because processes are faster than threads on llvmpipe.
int drawingJobs(int wanted, Driver driver, std::size_t pieces);
/// `wanted` workers for work without a context; 0: one per processor.
int readingJobs(int wanted);
/// Call it in a worker before its context is opened. Divides the processors among the software rasterisers of
/// `jobs` workers, of which at most `pieces` have work. A value that the user has set stays.
void shareProcessors(int jobs, std::size_t pieces);

/// The file of a shot in a folder of rendered pictures.
std::filesystem::path pictureFile(const std::filesystem::path& folder, const Suite& suite, const Shot& shot,
                                  bool severalSuites);

}  // namespace glibra::suite
