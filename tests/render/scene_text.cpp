#include "scene_text.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "../support/new_folder.h"

namespace glibra::test {
namespace {

/// A renderer of its own for each picture: other tests of the process have contexts too, and a renderer that
/// was opened before them would no longer be the current one.
Renderer renderer() {
    Result<Renderer> opened = Renderer::open();
    if (!opened) throw std::runtime_error(text(opened.diagnostics));
    return std::move(*opened);
}

}  // namespace

Result<Picture> tryPicture(const std::string& scene, const std::map<std::string, std::string>& files,
                           const RenderOptions& options) {
    const std::filesystem::path folder = newFolder("scene");
    const auto write = [&](const std::string& file, const std::string& content) {
        std::ofstream(folder / file, std::ios::binary) << content;
    };
    write("scene.glib", scene);
    for (const auto& [file, content] : files) write(file, content);
    Result<Picture> result = renderer().render(folder / "scene.glib", options);
    std::filesystem::remove_all(folder);
    return result;
}

Picture picture(const std::string& scene, const std::map<std::string, std::string>& files,
                const RenderOptions& options) {
    Result<Picture> result = tryPicture(scene, files, options);
    if (!result) {
        ADD_FAILURE() << text(result.diagnostics);
        Picture none;
        none.width = none.height = 1;
        none.data.resize(4);
        return none;
    }
    return std::move(*result);
}

int countPixels(const Picture& picture, std::array<int, 3> color) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) count += pixel(picture, x, y) == color ? 1 : 0;
    return count;
}

bool has(const Diagnostics& diagnostics, const std::string& id) {
    for (const Diagnostic& each : diagnostics)
        if (each.id == id) return true;
    return false;
}

std::string text(const Diagnostics& diagnostics) {
    std::string all;
    for (const Diagnostic& each : diagnostics) all += toString(each) + "\n";
    return all;
}

}  // namespace glibra::test
