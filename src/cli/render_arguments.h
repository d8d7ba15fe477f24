#pragma once
// What the command line of `glibra render` states.

#include <glibra/render.h>

#include <optional>
#include <string>
#include <vector>

#include "cli/suite_options.h"
#include "render/file/job.h"
#include "suite/suite.h"

namespace glibra::cli {

struct RenderArguments : render::JobOptions {
    std::vector<std::string> scenes;
    /// The text of the scene kStandardInput, if it is one of them.
    std::optional<std::string> standardInput;
    std::string output;           ///< file or folder; empty: the scenes' names in the current folder
    bool outputIsFolder = false;  ///< `output` is a folder, whether it exists or not
    std::string statsFile;        ///< --stats; "-" is standard output
    suite::Shot picture;          ///< what the options of a picture state
    Driver driver = Driver::automatic;
    int jobs = 0;  ///< 0: gpu::usualWorkers()
    SuiteArguments suite;
    std::vector<std::string> saves;  ///< --save, each NAME=FILE
    bool untrusted = false;
};

}  // namespace glibra::cli
