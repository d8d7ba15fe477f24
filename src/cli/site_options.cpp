#include "cli/site_options.h"

#include <system_error>
#include <utility>

#include "cli/commands.h"
#include "cli/picture_options.h"
#include "cli/untrusted.h"
#include "cli/written_files.h"

namespace glibra::cli {

namespace fs = std::filesystem;

void addSiteOptions(CommandLine& command, SiteOptions& to, const char* siteHelp,
                    std::initializer_list<const char*> picture) {
    command.option("-o,--output", to.site, siteHelp).written().withDefault();
    for (const char* each : picture) addPictureOption(command, each, to.picture);
    command.option("--timeout", to.timeout, "seconds that one picture may take; 0 means no limit")
        .within(0, 1e6)
        .withDefault();
    command.driver(to.driver);
    command.jobs(to.jobs);
    addUntrustedOption(command, to.untrusted);
}

bool mayWriteSite(const SiteOptions& options) {
    std::error_code failure;
    if (options.siteIsNamed || !fs::is_symlink(options.site, failure)) return true;
    print({linkedFolder(options.site, "-o")});
    return false;
}

Confinement confinement(base::Sandbox drawing, const fs::path& site) {
    Confinement made;
    made.reading = drawing;
    made.reading->readable.emplace_back(site, fs::path("pictures"));
    drawing.writable.emplace_back(site, fs::path("pictures"));
    makeWritableFolders(drawing);
    made.drawing = std::move(drawing);
    return made;
}

suite::SiteWorkers siteWorkers(const SiteOptions& options, const Confinement& confined) {
    suite::SiteWorkers workers;
    workers.driver = options.driver;
    workers.jobs = options.jobs;
    workers.timeout = options.timeout;
    workers.memory = options.picture.memory;
    workers.drawing = confined.drawing ? &*confined.drawing : nullptr;
    workers.reading = confined.reading ? &*confined.reading : nullptr;
    return workers;
}

}  // namespace glibra::cli
