#include "cli/render_outputs.h"

#include <algorithm>
#include <set>
#include <string>

#include "cli/scene_arguments.h"
#include "image/video/video_file.h"

namespace glibra::cli {

namespace fs = std::filesystem;

namespace {

bool writesIntoFolder(const RenderArguments& arguments) {
    return arguments.outputIsFolder || fs::is_directory(arguments.output) || arguments.output.back() == '/';
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
        fs::path common = fs::absolute(arguments.scenes.front()).lexically_normal().parent_path();
        for (const std::string& scene : arguments.scenes) {
            const fs::path folder = fs::absolute(scene).lexically_normal().parent_path();
            while (!common.empty() && common != common.parent_path() &&
                   std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first !=
                       common.end())
                common = common.parent_path();
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = fs::absolute(arguments.scenes[i])
                           .lexically_normal()
                           .lexically_relative(common)
                           .replace_extension(".png");
    }
    if (arguments.output.empty()) return names;
    const bool isFolder = writesIntoFolder(arguments);
    for (fs::path& name : names)
        name = isFolder ? fs::path(arguments.output) / name : fs::path(arguments.output);
    return names;
}

bool isFilm(const RenderArguments& arguments) {
    return arguments.frames > 1 && !arguments.outputIsFolder && !fs::is_directory(arguments.output) &&
           image::holdsAnimation(arguments.output);
}

fs::path framesOf(fs::path film) {
    return film.replace_extension(".png");
}

}  // namespace glibra::cli
