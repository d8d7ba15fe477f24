#include "cli/untrusted.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "cli/commands.h"
#include "gpu/context/hardware.h"
#include "image/module_loader.h"
#include "scene/file_lookup.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The path without links; itself if that is impossible.
fs::path real(const fs::path& path) {
    std::error_code failure;
    fs::path found = fs::weakly_canonical(path.empty() ? "." : path, failure);
    return failure ? path : found;
}

bool isBelow(const fs::path& path, const fs::path& folder) {
    const fs::path inside = real(path);
    const fs::path outside = real(folder);
    return std::mismatch(outside.begin(), outside.end(), inside.begin(), inside.end()).first == outside.end();
}

void addScene(std::set<fs::path>& readable, const fs::path& scene, const RenderOptions& options) {
    readable.insert(folderOf(scene));
    const scene::SearchFolders folders = scene::searchFolders(scene, {.libraryRoots = options.libraryRoots});
    readable.insert(folders.library.begin(), folders.library.end());
}

base::Sandbox sandboxWith(const std::set<fs::path>& readable, Driver driver) {
    base::Sandbox sandbox;
    sandbox.readable.assign(readable.begin(), readable.end());
    for (const fs::path& each : image::defaultModuleFolders())
        sandbox.readable.push_back(each / "glibra_openimageio.so");
    // Where users keep drivers of their own.
    for (const char* name : {"LD_LIBRARY_PATH", "LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_DIRS"})
        for (fs::path& each : foldersIn(name)) sandbox.readable.push_back(std::move(each));
    if (!gpu::mayUseHardware(driver)) return sandbox;
    for (const char* each :
         {"/dev/dri", "/dev/nvidiactl", "/dev/nvidia-modeset", "/dev/nvidia-uvm", "/dev/dxg"})
        sandbox.devices.emplace_back(each);
    constexpr int kMostDevices = 16;
    for (int i = 0; i < kMostDevices; ++i) sandbox.devices.emplace_back(fmt::format("/dev/nvidia{}", i));
    return sandbox;
}

}  // namespace

void addUntrustedOption(CommandLine& command, bool& to) {
    command.flag("--untrusted", to,
                 "confine the processes that read the scenes: no files but the scenes' and the libraries', "
                 "no network, no other programs (Linux)");
}

bool prepareUntrusted() {
    if (const std::string missing = base::missingForSandbox(); !missing.empty()) {
        printError("--untrusted cannot be kept on this system: " + missing);
        return false;
    }
    // A cache that a scene could write to would carry its shaders into later runs.
    for (const char* each : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"})
        ::setenv(each, "true", 1);
    ::setenv("__GL_SHADER_DISK_CACHE", "0", 1);
    return true;
}

base::Sandbox sandboxOf(const std::vector<std::string>& scenes, const RenderOptions& options, Driver driver) {
    std::set<fs::path> readable;
    for (const std::string& each : scenes) addScene(readable, each, options);
    return sandboxWith(readable, driver);
}

std::optional<base::Sandbox> sandboxOf(const Selection& selection, Driver driver, const fs::path& goldens,
                                       const std::vector<fs::path>& folders) {
    Diagnostics problems;
    std::set<fs::path> readable;
    std::set<fs::path> checked;
    const std::vector<fs::path> roots = libraryRoots();
    const auto check = [&](const suite::Suite& suite, const char* what, const fs::path& path,
                           const Place& place) {
        std::error_code failure;
        const fs::path own = fs::is_directory(suite.file, failure) ? suite.file : folderOf(suite.file);
        if (!checked.insert(path).second || isBelow(path, own) || isBelow(path, ".")) return;
        problems.push_back(
            withoutId(Severity::error,
                      fmt::format("--untrusted: the {} '{}' must be below the suite's folder or the "
                                  "current one",
                                  what, path.string()),
                      place));
    };
    std::set<fs::path> scenes;
    for (const suite::ShotReference& each : selection.shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        const suite::Shot& shot = suite.shots[each.shot];
        check(suite, "scene", shot.script, shot.place);
        for (const fs::path& root : shot.options.libraryRoots)
            if (std::find(roots.begin(), roots.end(), root) == roots.end())
                check(suite, "library", root, shot.place);
        // Shots of one folder have the same neighbours, but a library of their own perhaps.
        if (scenes.insert(folderOf(shot.script)).second || !shot.options.libraryRoots.empty())
            addScene(readable, shot.script, shot.options);
    }
    for (const suite::Suite& each : selection.suites) {
        if (goldens.empty()) check(each, "folder of goldens", each.goldens, {each.file.string(), 1, 1});
        readable.insert(goldens.empty() ? each.goldens : goldens / each.name);
    }
    for (const fs::path& folder : folders)
        for (const fs::path& each : readable)
            if (isBelow(each, folder))
                problems.push_back(withoutId(
                    Severity::error,
                    fmt::format("--untrusted: the folder '{}', which is written to, must not contain '{}'",
                                folder.string(), each.string())));
    print(problems);
    if (!problems.empty()) return std::nullopt;
    base::Sandbox sandbox = sandboxWith(readable, driver);
    sandbox.writable = folders;
    return sandbox;
}

void makeWritableFolders(const base::Sandbox& sandbox) {
    for (const fs::path& folder : sandbox.writable) {
        std::error_code ignored;  // reported with the file that cannot be written
        fs::create_directories(folder, ignored);
    }
}

StagingFolder::StagingFolder(const fs::path& parent)
    : path_((parent.empty() ? fs::path(".") : parent) / fmt::format(".glibra-{}-untrusted", ::getpid())) {
    std::error_code ignored;  // reported with the file that cannot be written
    fs::create_directories(path_, ignored);
}

StagingFolder::~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path StagingFolder::fileOf(std::size_t piece, const fs::path& target) const {
    const fs::path folder = path_ / std::to_string(piece);
    std::error_code ignored;  // reported with the file that cannot be written
    fs::create_directory(folder, ignored);
    return folder / target.filename();
}

std::optional<fs::path> StagingFolder::find(std::size_t piece, const fs::path& target) const {
    fs::path file = path_ / std::to_string(piece) / target.filename();
    struct stat status {};
    if (::lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return file;
}

Diagnostics StagingFolder::deliver(std::size_t piece, const fs::path& target) const {
    const fs::path file = path_ / std::to_string(piece) / target.filename();
    const auto refuse = [&](const std::string& why) {
        return Diagnostics{diagnose("file-E10", fmt::format("cannot write '{}': {}", target.string(), why))};
    };
    struct stat status {};
    if (::lstat(file.c_str(), &status) != 0) return {};
    if (!S_ISREG(status.st_mode)) return refuse("the process that drew it made something else of it");
    // A link keeps its target, as with files that are written directly.
    const fs::path place = real(target);
    if (::stat(place.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        return refuse("with --untrusted only ordinary files are written");
    std::error_code failure;
    fs::rename(file, place, failure);
    return failure ? refuse(failure.message()) : Diagnostics{};
}

}  // namespace glibra::cli
