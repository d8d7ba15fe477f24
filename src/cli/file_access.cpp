#include "cli/file_access.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <system_error>

#include "base/contained.h"
#include "cli/commands.h"
#include "cli/scene_arguments.h"
#include "gpu/context/context.h"
#include "image/module_loader.h"
#include "render/file/job.h"
#include "scene/file_lookup.h"
#include "suite/file/shot_name.h"
#include "system/folder.h"
#include "system/library.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::cli {

namespace fs = std::filesystem;

void ReadFiles::add(const fs::path& file, std::string_view what) {
    if (file.empty()) return;
    files_.try_emplace(render::filePlaceOf(file), what);
    std::error_code failure;
    if (const fs::path target = fs::canonical(file, failure); !failure) files_.try_emplace(target, what);
}

void ReadFiles::add(const Selection& selection, const suite::ShotInputs& inputs) {
    for (const suite::Suite& each : selection.suites) {
        std::error_code failure;
        if (!fs::is_directory(each.file, failure)) add(each.file, "it is a suite of this run");
    }
    for (const auto& [shot, read] : inputs) {
        const fs::path& script = selection.suites[shot.suite].shots[shot.shot].script;
        for (const fs::path& each : read.files)
            add(each, each == script ? std::string("it is a scene of this run")
                                     : fmt::format("the scene '{}' reads it", script.generic_string()));
    }
}

Diagnostics ReadFiles::overwrittenBy(const fs::path& file, std::string_view option) const {
    std::error_code failure;
    if (!fs::exists(file, failure)) return {};
    auto found = files_.find(render::filePlaceOf(file));
    if (const fs::path target = fs::canonical(file, failure); found == files_.end() && !failure)
        found = files_.find(target);
    if (found == files_.end()) return {};
    return {diagnose("file-E13", fmt::format("{}: '{}' is not written over, because {}; choose another name",
                                             option, file.generic_string(), found->second))};
}

ReadFiles filesReadBy(std::span<const std::string> scenes, const std::optional<std::string>& standardInput,
                      const RenderOptions& options, const base::WorkerOptions& workers) {
    std::vector<suite::SceneQuery> queries;
    for (const std::string& each : scenes)
        queries.push_back({each, optionsFor(each, standardInput, options)});
    const std::vector<suite::SceneInputs> inputs = suite::readInputs(queries, workers);
    ReadFiles read;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const fs::path& each : inputs[i].files)
            read.add(each, each == scenes[i] ? std::string("it is a scene of this command")
                                             : fmt::format("the scene '{}' reads it", scenes[i]));
    return read;
}

Diagnostic linkedFolder(const fs::path& folder, std::string_view option) {
    return image::cannotWrite(folder,
                              fmt::format("it is a link, which is followed only if {} names it", option));
}

bool anyExists(std::span<const fs::path> files) {
    return std::any_of(files.begin(), files.end(), [](const fs::path& each) {
        std::error_code failure;
        return fs::exists(each, failure);
    });
}

namespace {

using system::FileKind;
using system::Links;

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The way from a folder that the user named down to a path, as it is written. Nothing if the path does not
/// lead down from there.
std::optional<system::Reach> reachBelow(const fs::path& folder, const fs::path& path) {
    std::error_code failure;
    const auto plain = [&](const fs::path& each) {
        const fs::path whole = fs::absolute(each.empty() ? "." : each, failure).lexically_normal();
        return whole.has_filename() ? whole : whole.parent_path();
    };
    const fs::path inside = plain(path);
    for (const fs::path& root : {plain(folder), system::realPath(folder)}) {
        const fs::path below = inside.lexically_relative(root);
        if (!failure && !below.empty() && *below.begin() != "..") return system::Reach(root, below);
    }
    return std::nullopt;
}

/// The first link on the way down from the root.
std::optional<fs::path> linkOn(const system::Reach& reach) {
    if (reach.root.empty()) return std::nullopt;
    fs::path way = reach.root;
    for (const fs::path& part : reach.path) {
        way /= part;
        std::error_code failure;
        if (fs::is_symlink(fs::symlink_status(way, failure))) return way;
    }
    return std::nullopt;
}

/// What the workers may read. Links are named once.
class Readable {
  public:
    void add(system::Reach reach) {
        const std::optional<fs::path> link = linkOn(reach);
        if (!link) {
            found_.insert(std::move(reach));
        } else if (linked_.insert(*link).second) {
            problems_.push_back(diagnose(
                "file-W18", fmt::format("--untrusted: '{}' is a link, which is not followed; name the "
                                        "folder that it leads to, as with --library",
                                        link->generic_string())));
        }
    }

    /// The folders of the library that the look-up of a scene's files searches.
    void addLibrary(const fs::path& scene, const RenderOptions& options) {
        const scene::SearchFolders folders =
            scene::searchFolders(scene, {.libraryRoots = options.libraryRoots});
        for (std::size_t i = 0; i < folders.library.size(); ++i)
            if (std::optional<system::Reach> reach = reachBelow(folders.roots[i], folders.library[i]))
                add(std::move(*reach));
    }

    [[nodiscard]] const std::set<system::Reach>& all() const { return found_; }
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }

  private:
    std::set<system::Reach> found_;
    std::set<fs::path> linked_;
    Diagnostics problems_;
};

system::Sandbox sandboxWith(const Readable& readable, Driver driver) {
    print(readable.problems());
    system::Sandbox sandbox;
    sandbox.readable.assign(readable.all().begin(), readable.all().end());
    for (const fs::path& each : image::defaultModuleFolders())
        sandbox.readable.emplace_back(each / system::moduleName("glibra_openimageio"));
    // Where users keep drivers of their own.
    for (const char* name : {"LD_LIBRARY_PATH", "LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_DIRS"})
        for (fs::path& each : system::foldersIn(name)) sandbox.readable.emplace_back(std::move(each));
    if (gpu::mayUseHardware(driver)) addGraphicsDevices(sandbox);
    return sandbox;
}

}  // namespace

void addUntrustedOption(CommandLine& command, bool& to) {
    command.flag("--untrusted", to,
                 "confine the processes that read the scenes: no files but the scenes' and the libraries', "
                 "no network, no other programs (Linux)");
}

bool prepareUntrusted() {
    if (const std::string missing = system::missingForSandbox(); !missing.empty()) {
        printError("--untrusted cannot be kept on this system: " + missing);
        return false;
    }
    // A cache that a scene could write to would carry its shaders into later runs.
    for (const char* each : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"})
        system::setVariable(each, "true", system::Replace::yes);
    system::setVariable("__GL_SHADER_DISK_CACHE", "0", system::Replace::yes);
    return true;
}

system::Sandbox sandboxOf(const std::vector<std::string>& scenes, const RenderOptions& options,
                          Driver driver) {
    Readable readable;
    for (const std::string& each : scenes) {
        readable.add(folderOf(each));
        readable.addLibrary(each, options);
    }
    return sandboxWith(readable, driver);
}

std::optional<system::Sandbox> sandboxOf(const Selection& selection, Driver driver, const fs::path& goldens,
                                         const std::vector<system::Reach>& folders) {
    Diagnostics problems;
    Readable readable;
    std::set<fs::path> known;
    const std::vector<fs::path> roots = libraryRoots();
    // The way to something that a suite names. It must lead down from the suite's folder or the current one.
    const auto wayTo = [&](const suite::Suite& suite, const char* what, const fs::path& path,
                           const Place& place) {
        std::error_code failure;
        const fs::path own = fs::is_directory(suite.file, failure) ? suite.file : folderOf(suite.file);
        std::optional<system::Reach> way = reachBelow(own, path);
        if (!way) way = reachBelow(".", path);
        const std::optional<fs::path> link = way ? linkOn(*way) : std::nullopt;
        if (way && !link) return way;
        if (known.insert(path).second)
            problems.push_back(
                withoutId(Severity::error,
                          link ? fmt::format("--untrusted: the {} '{}' is reached through a link, which "
                                             "is not followed",
                                             what, path.generic_string())
                               : fmt::format("--untrusted: the {} '{}' must be below the suite's folder or "
                                             "the current one",
                                             what, path.generic_string()),
                          place));
        return std::optional<system::Reach>();
    };
    std::set<fs::path> scenes;
    for (const suite::ShotReference& each : selection.shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        const suite::Shot& shot = suite.shots[each.shot];
        for (const fs::path& root : shot.options.libraryRoots)
            if (std::find(roots.begin(), roots.end(), root) == roots.end())
                wayTo(suite, "library", root, shot.place);
        // Shots of one folder have the same neighbours, but a library of their own perhaps.
        const bool isNew = scenes.insert(folderOf(shot.script)).second;
        if (!isNew && shot.options.libraryRoots.empty()) continue;
        if (std::optional<system::Reach> way = wayTo(suite, "scene", folderOf(shot.script), shot.place))
            readable.add(std::move(*way));
        readable.addLibrary(shot.script, shot.options);
    }
    for (const suite::Suite& each : selection.suites) {
        if (!goldens.empty())
            readable.add({goldens, each.name});
        else if (std::optional<system::Reach> way =
                     wayTo(each, "folder of goldens", each.goldens, {each.file.generic_string(), 1, 1}))
            readable.add(std::move(*way));
        // Most pictures of a store are not needed, so one that lies elsewhere is no reason to refuse the
        // suite.
        if (each.store.empty() || suite::isAddress(each.store)) continue;
        for (const fs::path& from : {folderOf(each.file), fs::path(".")})
            if (std::optional<system::Reach> way = reachBelow(from, each.store); way && !linkOn(*way)) {
                readable.add(std::move(*way));
                break;
            }
    }
    for (const system::Reach& folder : folders) {
        if (const std::optional<fs::path> link = linkOn(folder))
            problems.push_back(withoutId(
                Severity::error, fmt::format("--untrusted: '{}' on the way to what is written is a link",
                                             link->generic_string())));
        for (const system::Reach& each : readable.all())
            if (system::isBelow(each.whole(), folder.whole()))
                problems.push_back(withoutId(
                    Severity::error,
                    fmt::format("--untrusted: the folder '{}', which is written to, must not contain '{}'",
                                folder.whole().generic_string(), each.whole().generic_string())));
    }
    print(problems);
    if (!problems.empty()) return std::nullopt;
    system::Sandbox sandbox = sandboxWith(readable, driver);
    sandbox.writable = folders;
    return sandbox;
}

void makeWritableFolders(const system::Sandbox& sandbox) {
    for (const system::Reach& each : sandbox.writable)  // a failure is reported with what cannot be written
        base::makeFoldersBeneath(each.root.empty() ? each.path : each.root,
                                 each.root.empty() ? fs::path(".") : each.path);
}

StagingFolder::StagingFolder(const fs::path& parent) {
    // A stranger may have made a folder, or a link, of any name. Only a new folder is ours.
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts && path_.empty(); ++attempt) {
        fs::path name = (parent.empty() ? fs::path(".") : parent) /
                        fmt::format(".glibra-{}{}{}", system::ownNumber(), image::kStaging,
                                    attempt == 0 ? "" : fmt::format("-{}", attempt));
        const int problem = system::makePrivateFolder(name);
        if (problem == 0)
            path_ = std::move(name);
        else if (problem != EEXIST)
            return;
    }
}

StagingFolder::~StagingFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
}

fs::path StagingFolder::fileOf(std::size_t piece, const fs::path& target) const {
    const fs::path folder = path_ / std::to_string(piece);
    std::error_code ignored;  // reported with the file that cannot be written
    fs::create_directory(folder, ignored);
    return folder / target.filename();
}

std::optional<fs::path> StagingFolder::find(std::size_t piece, const fs::path& target) const {
    fs::path file = path_ / std::to_string(piece) / target.filename();
    if (system::kindOf(file, Links::notFollowed) != FileKind::regular) return std::nullopt;
    return file;
}

Diagnostics StagingFolder::deliver(std::size_t piece, const fs::path& target, image::NamedBy named) const {
    const fs::path file = path_ / std::to_string(piece) / target.filename();
    const auto refuse = [&](const std::string& why) {
        return Diagnostics{
            diagnose("file-E10", fmt::format("cannot write '{}': {}", target.generic_string(), why))};
    };
    const FileKind made = system::kindOf(file, Links::notFollowed);
    if (made == FileKind::missing) return {};
    if (made != FileKind::regular) return refuse("the process that drew it made something else of it");
    // A link that the user named keeps its target, as with files that are written directly.
    const bool isNamed = named == image::NamedBy::user;
    const fs::path place = isNamed ? system::realPath(target) : target;
    const FileKind there = system::kindOf(place, Links::notFollowed);
    if (there != FileKind::missing && there != FileKind::regular && (isNamed || there != FileKind::link))
        return refuse("with --untrusted only ordinary files are written");
    return image::moveIntoPlace(file, place, named);
}

}  // namespace glibra::cli
