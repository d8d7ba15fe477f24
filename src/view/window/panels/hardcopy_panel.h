#pragma once
// The entries of the section "Hardcopy".

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "view/export/hardcopy_job.h"

namespace glibra::view {

struct HardcopyEntries {
    std::array<char, 1024> file{};    ///< a name in the folder of the settings, or a path
    std::string proposed;             ///< what `file` had when a free name was proposed last
    std::string stem;                 ///< of the proposed name, without the number that makes it free
    std::filesystem::path scene;      ///< the scene that the name was proposed for
    int preset = 0;                   ///< of the sizes in the menu
    int width = 1920, height = 1080;  ///< of the preset "other"
    int frames = 1;
    float framesPerSecond = 30;
    std::optional<HardcopyJob> job;  ///< running now
    std::string message;             ///< the result of the last hardcopy
    std::string note;                ///< what the running one leaves out
    bool failed = false;
    std::filesystem::path last;  ///< the first file of the last hardcopy
    bool asks = false;           ///< whether to replace a file
};

}  // namespace glibra::view
