#include "cli/render_outputs.h"

#include <algorithm>
#include <set>
#include <string>
#include <system_error>

#include "cli/scene_arguments.h"
#include "image/video/video_file.h"

namespace glibra::cli {

namespace fs = std::filesystem;

namespace {

/// False for a path that cannot be looked up, too: the file there is reported when it is written.
bool isFolder(const fs::path& path) {
    std::error_code failed;
    return fs::is_directory(path, failed);
}

bool writesIntoFolder(const RenderArguments& arguments) {
    return arguments.outputIsFolder || isFolder(arguments.output) || arguments.output.back() == '/';
}

/// The scene itself if there is no current folder any more.
fs::path absolutePath(const std::string& scene) {
    std::error_code failed;
    const fs::path path = fs::absolute(scene, failed);
    return (failed ? fs::path(scene) : path).lexically_normal();
}

}  // namespace

image::NamedBy namedBy(const RenderArguments& arguments) {
    return arguments.output.empty() || arguments.frames > 1 || writesIntoFolder(arguments)
               ? image::NamedBy::program
               : image::NamedBy::user;
}

std::vector<fs::path> outputFiles(const RenderArguments& arguments) {
    std::vector<fs::path> names;
    std::set<std::string> distinct;
    for (const std::string& scene : arguments.scenes) {
        names.push_back(scene == kStandardInput ? "stdin.png"
                                                : fs::path(scene).filename().replace_extension(".png"));
        distinct.insert(names.back().string());
    }
    if (distinct.size() < names.size()) {
        fs::path common = absolutePath(arguments.scenes.front()).parent_path();
        for (const std::string& scene : arguments.scenes) {
            const fs::path folder = absolutePath(scene).parent_path();
            while (!common.empty() && common != common.parent_path() &&
                   std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first !=
                       common.end())
                common = common.parent_path();
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = absolutePath(arguments.scenes[i]).lexically_relative(common).replace_extension(".png");
    }
    if (arguments.output.empty()) return names;
    const bool goesIntoFolder = writesIntoFolder(arguments);
    for (fs::path& name : names)
        name = goesIntoFolder ? fs::path(arguments.output) / name : fs::path(arguments.output);
    return names;
}

bool isFilm(const RenderArguments& arguments) {
    return arguments.frames > 1 && !arguments.outputIsFolder && !isFolder(arguments.output) &&
           image::holdsAnimation(arguments.output);
}

fs::path framesOf(fs::path film) {
    return film.replace_extension(".png");
}

}  // namespace glibra::cli
