#pragma once
// Draws and reviews a class in worker processes. A submission that crashes the driver, hangs or takes all
// memory affects only itself.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/sandbox.h"
#include "classroom/classroom.h"

namespace glibra::classroom {

struct ClassPlan {
    std::filesystem::path folder;  ///< of the submissions
    Submissions submissions;
    std::filesystem::path reference;  ///< its scene
    std::vector<Moment> moments;
    std::vector<std::filesystem::path> given;  ///< files and folders of code that all submissions start from
    std::filesystem::path site;                ///< pictures are written to SITE/pictures
};

struct ClassOptions {
    Driver driver = Driver::automatic;
    int jobs = 0;                            ///< worker processes; 0: gpu::usualWorkers()
    double timeout = 20;                     ///< seconds per picture; 0: no limit
    std::optional<std::uint64_t> memory;     ///< bytes per worker; 0: no limit; nothing: a share
    const base::Sandbox* drawing = nullptr;  ///< if given, what confines the workers that draw
    const base::Sandbox* reading = nullptr;  ///< ... and those that review
};

struct ClassEvents {
    std::function<void(const std::string& submission)> begins;
    /// Called once for every picture that is drawn or cannot be.
    std::function<void(bool failed)> done;
    std::function<bool()> stop;
};

struct ClassEnd {
    Classroom classroom;
    Diagnostics diagnostics;  ///< errors if the reference cannot be drawn, or there is no driver
    bool noDriver = false, stopped = false;
};

/// The number of pictures that runClass draws.
std::size_t pictureCount(const ClassPlan& plan);

/// Draws the reference, then every submission at the same moments and in the same size, then reviews all. If
/// a picture of a submission crashes or is late, its other pictures are not drawn. Pictures, page and table
/// of an earlier run are removed once the reference is drawn. Call it before any thread or GL context exists.
ClassEnd runClass(const ClassPlan& plan, const ClassOptions& options, const ClassEvents& events);

}  // namespace glibra::classroom
