#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/gallery_arguments.h"
#include "cli/library_hint.h"
#include "cli/picture_options.h"
#include "cli/scene_arguments.h"
#include "cli/suite_progress.h"
#include "cli/untrusted.h"
#include "gallery/gallery_run.h"
#include "system/interruption.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// The scenes of the site itself, if it lies in the folder, do not count.
std::vector<fs::path> scenesOf(const GalleryArguments& arguments, const std::vector<std::string>& found) {
    const fs::path site = wholePath(arguments.made.site);
    std::vector<fs::path> scenes;
    for (const std::string& each : found) {
        const fs::path inside = wholePath(each).lexically_relative(site);
        if (inside.empty() || *inside.begin() == "..") scenes.emplace_back(each);
    }
    return scenes;
}

/// Prepares what runGallery needs. Returns the exit status; kDone if all is well.
int planGallery(const GalleryArguments& arguments, gallery::GalleryPlan& plan) {
    if (std::error_code failure; !fs::is_directory(arguments.folder, failure))
        return refuse(fmt::format("there is no folder '{}'", arguments.folder));
    if (const std::string why = gallery::whyNoSite(arguments.made.site); !why.empty())
        return refuse(fmt::format("-o {}: {}", arguments.made.site, why));
    SceneArguments named;
    if (!arguments.scenes.empty())
        named.scenes = arguments.scenes;
    else if (printErrors(resolveScenes({arguments.folder}, named)))
        return kSceneIsWrong;
    if (arguments.isLive) {
        Result<std::string> runtime = page::packedRuntime();
        if (printErrors(runtime.diagnostics)) return kSceneIsWrong;
        plan.live = {arguments.page, std::move(*runtime), arguments.film};
    }
    plan.folder = arguments.folder;
    plan.site = arguments.made.site;
    plan.scenes = scenesOf(arguments, named.scenes);
    plan.title =
        !arguments.title.empty() ? arguments.title : wholePath(arguments.folder).filename().generic_string();
    constexpr int kWidth = 400, kHeight = 300;
    const RenderOptions& picture = arguments.made.picture.options;
    plan.width = picture.width > 0 ? picture.width : kWidth;
    plan.height = picture.height > 0 ? picture.height : kHeight;
    plan.libraryRoots = picture.libraryRoots;
    for (fs::path& each : libraryRoots()) plan.libraryRoots.push_back(std::move(each));
    if (std::optional<fs::path> library = libraryAbove(arguments.folder))
        plan.libraryRoots.push_back(std::move(*library));
    return kDone;
}

void reportScenes(const gallery::Gallery& made, const fs::path& folder) {
    for (const gallery::GalleryScene& each : made.scenes)
        if (!gallery::isDrawn(each))
            printLine(
                base::printableText(fmt::format("{}: {}: {}", each.path, name(each.verdict), each.reason)));
    for (const gallery::GalleryScene& each : made.scenes)
        if (const Diagnostics hint = libraryHint(folder / each.path, each.diagnostics); !hint.empty()) {
            print(hint);
            break;
        }
    printLine(gallery::summary(made));
}

}  // namespace

int makeGallery(const GalleryArguments& arguments) {
    if (arguments.made.untrusted && !prepareUntrusted()) return kNoDriver;
    if (!mayWriteSite(arguments.made)) return kSceneIsWrong;
    gallery::GalleryPlan plan;
    if (const int status = planGallery(arguments, plan); status != kDone) return status;
    Confinement confined;
    if (arguments.made.untrusted) {
        std::vector<std::string> scenes;
        for (const fs::path& each : plan.scenes) scenes.push_back(each.generic_string());
        RenderOptions options;
        options.libraryRoots = plan.libraryRoots;
        system::Sandbox drawing = sandboxOf(scenes, options, arguments.made.driver);
        drawing.readable.emplace_back(plan.folder);
        confined = confinement(std::move(drawing), plan.site);
    }

    const system::Interruption interruption;
    std::optional<SuiteProgress> progress;
    gallery::GalleryEvents events;
    events.starts = [&](std::size_t pictures) {
        progress.emplace(pictures, system::isTerminal(system::Standard::error));
    };
    events.begins = [&](const std::string& scene) {
        if (progress) progress->begins(scene);
    };
    events.done = [&](bool failed) {
        if (progress) progress->add(failed);
    };
    events.stop = [&] { return interruption.signal() != 0; };
    const gallery::GalleryEnd end = gallery::runGallery(plan, siteWorkers(arguments.made, confined), events);
    if (progress) progress->clear();
    print(end.diagnostics);
    if (end.noDriver) return kNoDriver;
    if (end.stopped) {
        printLine("stopped; no page was written");
        interruption.obey();
    }
    if (end.stopped || hasError(end.diagnostics)) return kSceneIsWrong;
    reportScenes(end.gallery, plan.folder);
    printLine("page: " + (plan.site / "index.html").generic_string());
    const std::vector<gallery::GalleryScene>& all = end.gallery.scenes;
    return std::all_of(all.begin(), all.end(), gallery::isDrawn) ? kDone : kSceneIsWrong;
}

void addGallery(CommandLine& program, int& status) {
    auto arguments = std::make_shared<GalleryArguments>();
    CommandLine command = program.subcommand(
        "gallery", "makes a site of a folder of scenes: pictures, films, ranges, sources, search",
        "glibra gallery scenes/ -o site/                      # site/index.html, for any browser\n"
        "glibra gallery scenes/ -o site/ --title 'Shaders, week 3' --size 640x480\n"
        "glibra gallery submissions/ -o site/ --untrusted     # scenes of strangers");
    GalleryArguments& to = *arguments;
    command.option("FOLDER", to.folder, "folder of scenes; those in the folders below it are shown by folder")
        .required();
    command.option("--title", to.title, "title of the site; by default the folder's name");
    addSiteOptions(command, to.made, "folder for the pages, pictures and films",
                   {"size", "library", "memory"});
    command.flag("--live", to.isLive,
                 "the scenes run on their pages, or films of them do (see `glibra publish`)");
    for (const char* each : {"--library", "--memory", "--timeout", "--driver", "--untrusted"})
        command.find(each).rare();
    command.onRun([arguments, site = command.find("--output"), &status] {
        arguments->made.siteIsNamed = site.isGiven();
        status = makeGallery(*arguments);
    });
}

}  // namespace glibra::cli
