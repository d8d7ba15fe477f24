#pragma once
// `glibra render SCENE...`: scenes to pictures, in worker processes.

#include <glibra/render.h>

#include <string>
#include <vector>

#include "cli/suite_options.h"
#include "suite/suite.h"

namespace glibra::cli {

struct RenderArguments {
    std::vector<std::string> scenes;
    std::string output;     ///< file or folder; empty: the scenes' names in the current folder
    std::string statsFile;  ///< --stats
    suite::Shot picture;    ///< what the options of a picture state
    Driver driver = Driver::automatic;
    int frames = 1;
    double framesPerSecond = 30;
    int jobs = 0;  ///< 0: one process per processor
    SuiteArguments suite;
    bool explain = false;
    bool untrusted = false;
};

/// Renders the scenes and prints what went wrong. Returns the exit status: the worst of all scenes.
int renderScenes(const RenderArguments& arguments);

}  // namespace glibra::cli
