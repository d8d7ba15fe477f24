#include "cli/written_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "cli/scene_arguments.h"
#include "image/file.h"
#include "render/file/job.h"
#include "suite/run/fingerprint.h"

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

}  // namespace glibra::cli
