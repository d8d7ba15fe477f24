#pragma once
// What a run of suites is to do, and what the workers are that draw and read other scenes.

#include <glibra/driver.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/sandbox.h"
#include "base/workers.h"
#include "suite/suite.h"

namespace glibra::suite {

class Orphans;

struct RunOptions {
    Driver driver = Driver::automatic;
    int jobs = 0;                         ///< worker processes; 0: gpu::usualWorkers()
    std::optional<double> timeout;        ///< seconds for every shot, instead of its own; 0: no limit
    std::optional<std::uint64_t> memory;  ///< bytes for every shot, instead of its own; 0: no limit
    bool update = false;                  ///< pictures that differ replace their goldens
    bool force = false;                   ///< ... even pictures of one colour or with NaN
    bool checkUndefined = false;          ///< RenderOptions::checkUndefined of all shots
    bool skip = true;                     ///< false: also makes and draws what the pictures do not need
    bool onlyMissing = false;             ///< ... only where there is no golden
    bool variant = false;                 ///< ... for this family of drivers alone
    bool also = false;                    ///< ... and are accepted beside them instead
    bool replaceUnreadable = false;       ///< ... even of goldens that cannot be read
    bool anyDriver = false;  ///< ... even of goldens for all drivers that another family of drivers drew
    bool prune = false;      ///< goldens of no shot are removed after the run
    std::vector<std::shared_ptr<const Orphans>> orphans{};  ///< one per suite, or none
    bool strictFlaky = false;                               ///< flaky shots are unstable
    bool allowOutside = false;        ///< goldens may be links to places outside of their folder
    std::filesystem::path goldens{};  ///< folder with one folder per suite, instead of the suites' own
    std::filesystem::path results{};  ///< folder for the pictures of failures
    bool refusesMisspelt = false;  ///< with `onlyRender`: misspelt names are errors (render/consequences.h)
    std::filesystem::path onlyRender{};      ///< if not empty: no goldens, pictures are written here by name
    const base::Sandbox* sandbox = nullptr;  ///< if given, what confines the workers; excludes `update`
};

/// The file of a shot in a folder of rendered pictures.
std::filesystem::path pictureFile(const std::filesystem::path& folder, const Suite& suite, const Shot& shot,
                                  bool severalSuites);

/// The worker processes that draw and read the scenes of a class or of a gallery.
struct SiteWorkers {
    Driver driver = Driver::automatic;
    int jobs = 0;                            ///< worker processes; 0: gpu::usualWorkers()
    double timeout = 20;                     ///< seconds per picture; 0: no limit
    std::optional<std::uint64_t> memory;     ///< bytes per worker; 0: no limit; nothing: a share
    const base::Sandbox* drawing = nullptr;  ///< if given, what confines the workers that draw
    const base::Sandbox* reading = nullptr;  ///< ... and those that read
};

/// For runShots(): the pictures are drawn into that folder, and not compared.
RunOptions drawingOptions(const SiteWorkers& workers, const std::filesystem::path& folder);
/// For base::runInWorkers(): so many pieces of work without a context.
base::WorkerOptions readingOptions(const SiteWorkers& workers, std::size_t pieces,
                                   const std::function<bool()>& stop);

}  // namespace glibra::suite
