#pragma once
// What `glibra test` and `glibra render --suite` have in common: the suites, and which of their shots.

#include <glibra/render.h>
#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "suite/run/run.h"
#include "suite/suite.h"

namespace CLI {
class App;
}

namespace glibra::cli {

struct SuiteArguments {
    std::vector<std::string> suites;  ///< TOML files, or folders of scenes
    std::vector<std::string> only;
    std::string shard;
    Driver driver = Driver::automatic;
    int jobs = 0;                   ///< 0: as many as the machine is best with
    std::optional<double> timeout;  ///< seconds
    bool resume = false;
    bool skip = true;  ///< false: --no-skip
    /// Runs also the shots that others name by `match` and `differ`; --update replaces only what is meant.
    bool withNamed = true;
};

/// --only, --shard, --resume.
void addSelectionOptions(CLI::App& command, SuiteArguments& to);

struct Selection {
    std::vector<suite::Suite> suites;
    std::vector<suite::ShotReference> shots;  ///< in the order of the suites
};

/// Reads the suites and finds the shots. What went wrong has been printed; `status` then says with which exit
/// status to end.
std::optional<Selection> readSelection(const SuiteArguments& arguments, int& status);

}  // namespace glibra::cli
