#pragma once
// Draws and reviews a class in worker processes. A submission that crashes the driver, hangs or takes all
// memory affects only itself.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "classroom/classroom.h"
#include "suite/run/run_options.h"

namespace glibra::classroom {

/// An earlier class, whose code alone is compared.
struct EarlierClass {
    std::string name;  ///< that stands before the names of its students: "2025"
    std::filesystem::path folder;
    Submissions submissions;
};

struct ClassPlan {
    std::filesystem::path folder;  ///< of the submissions
    Submissions submissions;
    std::filesystem::path reference;  ///< its scene; empty: nothing to compare with
    /// The reference's pictures, one per moment, instead of drawing its scene, which then need not exist.
    std::vector<std::filesystem::path> pictures{};
    std::vector<Moment> moments;  ///< Shot::ownUniforms are the names that the reference must have
    std::vector<std::filesystem::path> given;  ///< files and folders of code that all submissions start from
    std::size_t common = 0;                    ///< compareSources()
    std::filesystem::path site;                ///< pictures are written to SITE/pictures
    bool studentPages = false;                 ///< small pictures are made for them
    std::vector<EarlierClass> earlier{};
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
    bool misspelt = false;  ///< there is no uniform of a name that the moments set (suite-E19)
};

/// The number of pictures that runClass draws.
std::size_t pictureCount(const ClassPlan& plan);

/// Draws the reference, or takes its pictures, then every submission at the same moments and in the same
/// size, then reviews all. Submissions with errors are drawn as far as that is possible
/// (RenderOptions::incomplete). If a picture of a submission crashes or is late, its pictures of later
/// rounds are not drawn; the rounds have 1, 1, 2, 4 and then 8 pictures of each. Pictures, page and table of
/// an earlier run are removed once the reference is drawn. A name that is set and that the reference does not
/// have (or, without a reference, none of the submissions) ends the run before that. Call it before any
/// thread or GL context exists.
ClassEnd runClass(const ClassPlan& plan, const suite::SiteWorkers& workers, const ClassEvents& events);

}  // namespace glibra::classroom
