#pragma once
// The options of a picture (suite/options/option_table.h) on a command line.

#include <glibra/driver.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"
#include "system/sandbox.h"

namespace glibra::cli {

class CommandLine;
class Option;

/// Adds the option of one row; `name` is without "--". `to` must outlive the command.
void addPictureOption(CommandLine& command, std::string_view name, suite::Shot& to);
/// Adds all rows that have a name.
void addPictureOptions(CommandLine& command, suite::Shot& to);
/// Prints what is wrong with the values of --set; false if one of them cannot be read.
bool acceptsSet(const std::vector<std::string>& set);
/// Makes `suite`, the option --suite, exclude the options that a suite states itself.
void excludePictureOptions(CommandLine& command, Option& suite);

// The options that `glibra class` and `glibra gallery` share: both draw scenes, perhaps of strangers, and
// make a site of them.

struct SiteOptions {
    std::string site;
    bool siteIsNamed = false;  ///< by the user
    suite::Shot picture{};
    double timeout = 20;  ///< seconds: a class has a submission that never ends sooner than a suite has
    Driver driver = Driver::automatic;
    int jobs = 0;
    bool untrusted = false;
};

/// Adds -o, the options of a picture with these names, and how scenes are drawn. `to` must outlive the
/// command.
void addSiteOptions(CommandLine& command, SiteOptions& to, const char* siteHelp,
                    std::initializer_list<const char*> picture);

/// False if the site may not be written: it is a link that the user has not named. The reason has been
/// printed.
bool mayWriteSite(const SiteOptions& options);

/// What confines the workers: those that draw, and those that only read. Nothing without --untrusted.
struct Confinement {
    std::optional<system::Sandbox> drawing, reading;
};
/// `drawing` has everything but SITE/pictures, which it may write and the others may read.
Confinement confinement(system::Sandbox drawing, const std::filesystem::path& site);

/// The workers that the options ask for. `confined` must outlive them.
suite::SiteWorkers siteWorkers(const SiteOptions& options, const Confinement& confined);

}  // namespace glibra::cli
