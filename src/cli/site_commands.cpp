// `glibra gallery` and `glibra publish`: scenes as pages for a browser.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/contained_call.h"
#include "base/text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/picture_options.h"
#include "cli/render_answer.h"
#include "cli/scene_arguments.h"
#include "cli/suite_progress.h"
#include "gallery/gallery_run.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "page/page.h"
#include "scene/file_lookup.h"
#include "suite/run/run_options.h"
#include "system/folder.h"
#include "system/interruption.h"

namespace glibra::cli {
namespace {

// What the command lines of `glibra gallery` and of `glibra publish` for several scenes state.

struct GalleryArguments {
    std::string folder;
    std::vector<std::string> scenes{};  ///< below the folder; empty: all
    std::string title;
    SiteOptions made{.site = "glibra-gallery"};
    bool isLive = false;
    page::PageOptions page{};  ///< of live scenes
    page::FilmOptions film{};  ///< of the others
};

namespace fs = std::filesystem;

/// The scenes of the site itself, if it lies in the folder, do not count.
std::vector<fs::path> scenesOf(const GalleryArguments& arguments, const std::vector<std::string>& found) {
    std::vector<fs::path> scenes;
    for (const std::string& each : found)
        if (!system::isBelow(each, arguments.made.site)) scenes.emplace_back(each);
    return scenes;
}

/// The folders of --library, those of GLIBRA_PATH, and the library above a folder of scenes.
std::vector<fs::path> rootsWith(std::vector<fs::path> roots, const fs::path& folder) {
    for (fs::path& each : libraryRoots()) roots.push_back(std::move(each));
    if (std::optional<fs::path> library = scene::libraryAbove(system::realPath(folder)))
        roots.push_back(std::move(*library));
    return roots;
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
    plan.title = !arguments.title.empty() ? arguments.title
                                          : system::realPath(arguments.folder).filename().generic_string();
    constexpr int kWidth = 400, kHeight = 300;
    const RenderOptions& picture = arguments.made.picture.options;
    plan.width = picture.width > 0 ? picture.width : kWidth;
    plan.height = picture.height > 0 ? picture.height : kHeight;
    plan.libraryRoots = rootsWith(picture.libraryRoots, arguments.folder);
    return kDone;
}

void reportScenes(const gallery::Gallery& made, const fs::path& folder) {
    for (const gallery::GalleryScene& each : made.scenes)
        if (!gallery::isDrawn(each))
            printLine(fmt::format("{}: {}: {}", each.path, name(each.verdict), each.reason));
    for (const gallery::GalleryScene& each : made.scenes)
        if (const Diagnostics hint = libraryHint(folder / each.path, each.diagnostics); !hint.empty()) {
            print(hint);
            break;
        }
    printLine(gallery::summary(made));
}

/// Makes the site and prints what went wrong. Returns the exit status.
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

struct PublishArguments : GalleryArguments {
    std::vector<std::string> named;
    bool isExercise = false;
};

fs::path sceneFolder(const fs::path& scene) {
    return scene.has_parent_path() ? scene.parent_path() : fs::path(".");
}

/// The folder that all of the scenes are in.
fs::path commonFolder(const std::vector<std::string>& scenes) {
    fs::path common = system::realPath(sceneFolder(scenes.front()));
    for (const std::string& each : scenes) {
        const fs::path place = system::realPath(each);
        while (std::ranges::mismatch(common, place).in1 != common.end()) common = common.parent_path();
    }
    return common;
}

page::PageTask taskOf(const std::string& scene, const RenderOptions& picture) {
    page::PageTask task{scene, picture};
    task.options.within = sceneFolder(scene);
    task.options.libraryRoots = rootsWith(std::move(task.options.libraryRoots), task.options.within);
    return task;
}

/// The answer of the worker, or what stands for one.
page::PageScene pageFrom(const std::string& scene, const SiteOptions& options, const base::Outcome& outcome,
                         std::optional<page::PageScene> answer) {
    if (answer) return std::move(*answer);
    suite::Shot shot = options.picture;
    shot.timeout = options.timeout;
    page::PageScene none;
    none.diagnostics = answerOf(outcome, scene, shot, {"drew", "drawn"}).remarks.general;
    return none;
}

Diagnostics writePage(const page::PageScene& scene, const PublishArguments& arguments, const fs::path& file,
                      image::NamedBy named, const std::string& runtime) {
    ReadFiles read;
    for (const fs::path& each : scene.read) read.add(each, "the scene reads it");
    if (Diagnostics refused = read.overwrittenBy(file, "-o"); !refused.empty()) return refused;
    const fs::path stem = fs::path(arguments.named.front()).stem();
    const std::string page = page::wholePage(
        scene, arguments.page, arguments.title.empty() ? stem.generic_string() : arguments.title, runtime);
    return image::writeFileAtomically(file, std::as_bytes(std::span(page)), named);
}

/// One scene, one page. Returns the exit status.
int publishScene(const PublishArguments& arguments, const fs::path& file, image::NamedBy named) {
    const std::string& scene = arguments.named.front();
    page::PageTask task = taskOf(scene, arguments.made.picture.options);
    task.film = arguments.film;
    task.isExercise = arguments.isExercise;
    std::optional<system::Sandbox> sandbox;
    if (arguments.made.untrusted) {
        if (!prepareUntrusted()) return kNoDriver;
        sandbox = sandboxOf({scene}, task.options, arguments.made.driver);
        sandbox->readable.emplace_back(task.options.within);
    }
    const system::Interruption interruption;
    page::PageScene page;
    page::makePages({&task, 1}, arguments.made.driver,
                    {.timeout = arguments.made.timeout,
                     .memory = arguments.made.picture.memory.value_or(base::memoryShare(1, 1)),
                     .stop = [&] { return interruption.signal() != 0; },
                     .sharesDevice = gpu::mayUseHardware(arguments.made.driver),
                     .sandbox = sandbox ? &*sandbox : nullptr},
                    [&](std::size_t, const base::Outcome& outcome, std::optional<page::PageScene> answer) {
                        page = pageFrom(scene, arguments.made, outcome, std::move(answer));
                    });
    interruption.obey();
    print(page.diagnostics);
    print(libraryHint(scene, page.diagnostics));
    if (std::ranges::find(page.diagnostics, "file-E12", &Diagnostic::id) != page.diagnostics.end())
        print({withoutId(Severity::note,
                         "the scenes of a site may read whatever is in its folder: publish one that holds "
                         "both, glibra publish FOLDER -o site/")});
    if (page.noDriver) return kNoDriver;
    const bool isWrong = hasError(page.diagnostics);
    if (page.picture.empty() && !page.isLive) return kSceneIsWrong;
    std::string runtime;
    if (page.isLive) {
        Result<std::string> found = page::packedRuntime();
        if (printErrors(found.diagnostics)) return kSceneIsWrong;
        runtime = std::move(*found);
    }
    std::error_code ignored;  // what cannot be made is reported as the file that cannot be written
    if (named == image::NamedBy::program) fs::create_directories(file.parent_path(), ignored);
    if (printErrors(writePage(page, arguments, file, named, runtime))) return kSceneIsWrong;
    printLine(fmt::format("page: {}{}", file.generic_string(),
                          page.isLive ? std::string(isWrong ? " (an exercise: the scene has errors)" : "")
                                      : fmt::format(" (a {}, because browsers cannot draw the scene)",
                                                    page.film.pictures.size() > 1 ? "film" : "picture")));
    return isWrong && !page.isLive ? kSceneIsWrong : kDone;
}

int runPublishCommand(PublishArguments& arguments) {
    SceneArguments named;
    if (std::ranges::find(arguments.named, "-") != arguments.named.end())
        return refuse("a page is made of a scene with its files; name a scene (.glib), not standard input");
    if (printErrors(resolveScenes(arguments.named, named))) return kSceneIsWrong;
    const RenderOptions& picture = arguments.made.picture.options;
    if (!acceptsSet(picture.set)) return kWrongUsage;
    const std::string& output = arguments.made.site;
    arguments.page.width = picture.width;
    arguments.page.height = picture.height;
    arguments.page.samples = picture.samples;
    if (named.hasFolder || named.scenes.size() > 1) {
        if (!picture.set.empty() || picture.time != 0)
            return refuse("--set and --time are for the page of one scene");
        if (arguments.isExercise) return refuse("--exercise is for the page of one scene");
        if (!arguments.made.siteIsNamed) return refuse("name the folder of the site with -o");
        const bool isOneFolder = arguments.named.size() == 1;
        arguments.folder =
            isOneFolder ? arguments.named.front() : commonFolder(named.scenes).generic_string();
        if (!isOneFolder)
            for (const std::string& each : named.scenes)
                arguments.scenes.push_back(system::realPath(each).generic_string());
        arguments.isLive = true;
        return makeGallery(arguments);
    }
    arguments.page.set = picture.set;
    arguments.page.time = picture.time;
    std::error_code failure;
    const fs::path name = fs::path(arguments.named.front()).filename().replace_extension(".html");
    const bool intoFolder = output.empty() || output.back() == '/' || fs::is_directory(output, failure);
    return publishScene(arguments, intoFolder ? output / name : fs::path(output),
                        intoFolder ? image::NamedBy::program : image::NamedBy::user);
}

}  // namespace

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

void addPublish(CommandLine& program, int& status) {
    auto arguments = std::make_shared<PublishArguments>();
    CommandLine command = program.subcommand(
        "publish",
        "makes a page in which a scene, or a film of it, runs in a browser; or a site of such pages",
        "glibra publish teapot.glib                        # teapot.html: one file, for any browser\n"
        "glibra publish teapot.glib -o site/teapot.html --poster --set uKd=.8\n"
        "glibra publish scenes/ -o site/                   # site/index.html; the pages share one runtime");
    PublishArguments& to = *arguments;
    to.made.site.clear();
    to.made.picture.options.samples = page::kPageSamples;
    command.list("SCENE", to.named, "scene files (.glib) or folders of them").required();
    addSiteOptions(command, to.made, "file of the page, or folder of the site for several scenes",
                   {"size", "time", "set", "samples", "library", "memory"});
    command.option("--title", to.title, "heading of the page or site; by default its name");
    command.flag("--embed", to.page.isEmbedded,
                 "nothing but the scene and its controls, for a frame of another page");
    command.flag("--poster", to.page.hasPoster, "the picture stands there until it is clicked");
    command.flag("--exercise", to.isExercise,
                 "a scene with errors has a page, too, on which readers can mend it");
    command
        .option("--frames", to.film.frames,
                "pictures over time in the film of a scene that browsers cannot draw")
        .within(1, 1000)
        .withDefault();
    command
        .option("--seconds", to.film.seconds,
                "seconds of time in such a film; by default once round for Timer, else 3")
        .within(1e-3, 1e6);
    for (const char* each :
         {"--library", "--memory", "--timeout", "--driver", "--jobs", "--untrusted", "--frames", "--seconds"})
        command.find(each).rare();
    command.onRun([arguments, site = command.find("--output"), &status] {
        arguments->made.siteIsNamed = site.isGiven();
        status = runPublishCommand(*arguments);
    });
}

}  // namespace glibra::cli
