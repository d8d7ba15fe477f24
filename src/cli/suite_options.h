#pragma once
// The options that `glibra test` and `glibra render --suite` share: the suites, and which of their shots.

#include <glibra/render.h>
#include <glibra/result.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/workers.h"
#include "suite/run/run.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::cli {

class CommandLine;

struct SuiteArguments {
    std::vector<std::string> suites;  ///< TOML files, or folders of scenes
    std::vector<std::string> only;
    std::string shard;
    suite::RunOptions run{};
    bool resume = false;
    bool untrusted = false;
    /// Also runs the shots that others name by `match` and `differ`. With --update only the shots that --only
    /// names are replaced.
    bool withNamed = true;
};

/// Adds --only, --shard and --resume.
void addSelectionOptions(CommandLine& command, SuiteArguments& to);

struct Selection {
    std::vector<suite::Suite> suites;
    std::vector<suite::ShotReference> shots;      ///< in the order of the suites
    std::vector<suite::ShotReference> undivided;  ///< the shots of all shards
};

/// How to find out what the scenes of so many shots read (suite/run/fingerprint.h).
base::WorkerOptions inputWorkers(const SuiteArguments& arguments, std::size_t shots,
                                 const system::Sandbox* sandbox, std::function<bool()> stop);

/// Reads the suites and selects the shots. Without a value, the reason has been printed and `status` is the
/// exit status.
std::optional<Selection> readSelection(const SuiteArguments& arguments, int& status);

/// Prints the selected shots, as SUITE/SHOT. Returns the exit status.
int listShots(const SuiteArguments& arguments);

}  // namespace glibra::cli
