#pragma once
// What a run of suites is to do, and what the workers are that draw and read other scenes.

#include <glibra/driver.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/workers.h"
#include "suite/golden/hash_list.h"
#include "suite/results/results.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"
#include "system/sandbox.h"

namespace glibra::suite {

// Messages of a worker to its parent process during a piece: one line of text each.

/// The driver of the worker; sent once.
struct DriverIs {
    std::string words;
    std::string key{};  ///< driverKey()
};
/// The worker begins a shot. Its time limit begins now.
struct Begins {
    ShotReference shot;
};
/// What a worker does with a shot, besides beginning it. Each of drawing and judging has the time limit of
/// its shot, so that the parent knows which of the shots of a worker is late.
struct Phase {
    enum class Kind : char {
        awaits = 'w',  ///< the thread that draws now waits until this shot is prepared, or goes on with it
        drawn = 'e',   ///< it is drawn and waits for its verdict
        judges = 'j',  ///< the thread that judges begins with it
        recalls = 'r'  ///< ... has ended without a verdict: the shot is rendered once more
    };
    Kind kind{};
    ShotReference shot;
};
/// A shot has a verdict.
struct Done {
    ShotReference shot;
    ShotResult result;
    std::optional<AcceptedHash> accepted;
};
using Message = std::variant<DriverIs, Begins, Phase, Done>;

std::string toText(const Message& message);
/// The message, or nothing if the text is not a message.
std::optional<Message> parseMessage(const std::string& text);

// The number of worker processes, and what each of them may take of the processors.

/// `wanted` workers that draw `pieces` scenes or shots; 0: as many as draw them soonest. Where the processor
/// draws, that is one per processor, because processes are faster than threads on llvmpipe.
int drawingJobs(int wanted, Driver driver, std::size_t pieces);
/// `wanted` workers for work without a context; 0: one per processor.
int readingJobs(int wanted);
/// Call it in a worker before its context is opened. Divides the processors among the software rasterisers of
/// `jobs` workers, of which at most `pieces` have work. A value that the user has set stays.
void shareProcessors(int jobs, std::size_t pieces);

/// With `update`, goldens are replaced; `results` is the folder for the pictures of failures.
struct RunOptions : JudgeOptions {
    Driver driver = Driver::automatic;
    int jobs = 0;                         ///< worker processes; 0: gpu::usualWorkers()
    std::optional<double> timeout;        ///< seconds for every shot, instead of its own; 0: no limit
    std::optional<std::uint64_t> memory;  ///< bytes for every shot, instead of its own; 0: no limit
    Shot ofAll;                           ///< options of all shots, as giveToAll() takes them
    std::vector<std::shared_ptr<const Orphans>> orphansBySuite{};  ///< JudgeOptions::orphans, or none
    bool strictFlaky = false;                                      ///< flaky shots are unstable
    bool allowOutside = false;        ///< goldens may be links to places outside of their folder
    std::filesystem::path goldens{};  ///< folder with one folder per suite, instead of the suites' own
    bool refusesMisspelt = false;  ///< with `onlyRender`: misspelt names are errors (render/consequences.h)
    std::filesystem::path onlyRender{};  ///< if not empty: no goldens, pictures are written here by name
    const system::Sandbox* sandbox = nullptr;  ///< if given, what confines the workers; excludes `update`
};

/// The file of a shot in a folder of rendered pictures.
std::filesystem::path pictureFile(const std::filesystem::path& folder, const Suite& suite, const Shot& shot,
                                  bool severalSuites);

/// The worker processes that draw and read the scenes of a class or of a gallery.
struct SiteWorkers {
    Driver driver = Driver::automatic;
    int jobs = 0;                              ///< worker processes; 0: gpu::usualWorkers()
    double timeout = 20;                       ///< seconds per picture; 0: no limit
    std::optional<std::uint64_t> memory;       ///< bytes per worker; 0: no limit; nothing: a share
    const system::Sandbox* drawing = nullptr;  ///< if given, what confines the workers that draw
    const system::Sandbox* reading = nullptr;  ///< ... and those that read
};

/// For runShots(): the pictures are drawn into that folder, and not compared.
RunOptions drawingOptions(const SiteWorkers& workers, const std::filesystem::path& folder);
/// For base::runInWorkers(): so many pieces of work that compile shaders or draw.
base::WorkerOptions checkingOptions(const SiteWorkers& workers, std::size_t pieces,
                                    const std::function<bool()>& stop);
/// For base::runInWorkers(): so many pieces of work without a context.
base::WorkerOptions readingOptions(const SiteWorkers& workers, std::size_t pieces,
                                   const std::function<bool()>& stop);

}  // namespace glibra::suite
