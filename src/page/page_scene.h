#pragma once
// What a page of a scene is made of: every file that the scene reads, its picture, and whether browsers
// can draw it; if not, its film.

#include <glibra/diagnostic.h>
#include <glibra/driver.h>
#include <glibra/render.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "gpu/context/context.h"
#include "page/film.h"
#include "render/load/shared_parts.h"
#include "source/scene_head.h"

namespace glibra::page {

struct PageFile {
    std::string name;  ///< relative to the page's folder, with '/'
    std::string content;
    bool isConverted = false;  ///< a picture as PNG or PFM, whatever its name says
};

struct PageScene {
    std::string name;                         ///< of the scene, among its files
    std::vector<PageFile> files;              ///< sorted by their names
    std::vector<std::filesystem::path> read;  ///< the files of the disk that they come from
    source::SceneHead head;
    int width = 0, height = 0;  ///< of the picture
    std::string picture;        ///< a PNG file; empty if the scene cannot be drawn
    Diagnostics diagnostics;
    /// False if something that the scene needs is not in WebGL 2, or the scene has an error of its own and is
    /// no exercise: the diagnostics have it.
    bool isLive = false;
    /// Of a scene that is not live only for what WebGL 2 lacks, which are warnings then. No pictures: none.
    Film film;
    bool noDriver = false;  ///< nothing was drawn or checked
};

struct PageTask {
    std::filesystem::path scene;
    RenderOptions options;  ///< `within` says which files may be read, besides those of the library
    bool draws = true;      ///< false: without the picture of a live scene
    FilmOptions film{};
    bool isExercise = false;  ///< a scene with errors of its own is live, without a picture
};

/// The largest size of a window's shape that fits into the given one.
std::pair<int, int> fitting(int windowWidth, int windowHeight, int width, int height);

/// The most bytes that the files of a scene may have together.
inline constexpr std::size_t kLargestScene = std::size_t{256} << 20U;

/// The files of a scene as its page has them. They keep their places to each other, so that the runtime,
/// which takes the page for a library, finds them as on the disk: names are relative to the nearest folder
/// with `shaders` or `textures`, from the scene's own upwards, or else to the folder around the scene's; or
/// to another library folder. Pictures in formats that only the image module reads become PNG or PFM. Reads
/// nothing outside of `within` and the library, follows no link there, and opens nothing that is hidden.
/// Reports page-W01 for each file that is left out, page-E02 if all together are too large, and what
/// readImage() does for pictures.
std::vector<PageFile> filesOf(const PageTask& task, std::vector<std::filesystem::path>& read,
                              Diagnostics& problems);

/// Files of a live scene that have more bytes together are reported.
inline constexpr std::size_t kLargeScene = std::size_t{16} << 20U;

/// All of it. A scene with errors has what could be made of it. While a film is drawn, `step` gets toText()
/// of the page with the film so far, or an empty text after another picture.
PageScene pageScene(
    gpu::Context& context, const PageTask& task, render::SharedParts* shared,
    const base::Step& step = [](const std::string&) {});

/// Does pageScene() for each task in worker processes. `done` gets nothing for a worker that ended or was
/// late: the outcome says how; if that was while it drew a film, the film so far, with page-W02. Call it
/// before any thread or GL context exists.
void makePages(
    std::span<const PageTask> tasks, Driver driver, const base::WorkerOptions& workers,
    const std::function<void(std::size_t task, const base::Outcome&, std::optional<PageScene>)>& done);

/// As text for the pipe of a worker. parsePageScene returns nothing for text that is none.
std::string toText(const PageScene& scene);
std::optional<PageScene> parsePageScene(std::string_view text);

}  // namespace glibra::page
