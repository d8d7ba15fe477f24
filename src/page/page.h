#pragma once
// Pages of scenes: what they are made of, the films of those that browsers cannot draw, and their texts.

#include <glibra/diagnostic.h>
#include <glibra/driver.h>
#include <glibra/render.h>
#include <glibra/result.h>

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
#include "image/image.h"
#include "image/module_loader.h"
#include "render/load/shared_parts.h"
#include "source/scene_head.h"

namespace glibra::page {

// The film of a scene that browsers cannot draw: pictures over time, and over the values of each control.

/// How long a film is.
struct FilmOptions {
    int frames = 24;     ///< over time
    double seconds = 0;  ///< that they last; 0: once round, if the scene moves by Timer alone and returns
                         ///< within 4 seconds, else 3
    /// Its pictures have the shape of the scene's window and fit into this, unless the task states their
    /// size.
    int width = 320, height = 240;
};

struct Film {
    /// PNG files of different pictures. The first one is the scene as it begins; "parts" of the state are
    /// transparent where they are as the first one.
    std::vector<std::string> pictures;
    /// What the page is told (src/page/web/film.js), as JSON:
    /// { "width", "height": pixels of the pictures, "begin", "length": seconds of time,
    ///   "parts": [numbers of pictures that lie over the first one],
    ///   "frames": [a picture for each of the times, which are equally far apart],
    ///   "knobs": [as a live page has them, and for each component "stops": [[values in rising order]] and
    ///             "pictures": [[a picture for each]]: with that value, and all others as they begin],
    ///   "shared": [[indices of knobs that one control moves together]],
    ///   "files": [{ "name", "language": "glib" or "glsl" }] }
    std::string state;
    std::vector<std::string> texts;  ///< the names of those files
    int width = 0, height = 0;       ///< pixels
};

/// The most bytes that the pictures of a film have together.
inline constexpr std::size_t kLargestFilm = std::size_t{32} << 20U;

struct FilmTask {
    std::filesystem::path scene;
    RenderOptions options;
    FilmOptions film;
};

/// What filmOf() needs of the page.
struct FilmParts {
    std::function<std::string(const std::filesystem::path&)> nameOf;  ///< of a file on the page
    std::function<std::string(image::Image)> packed;                  ///< as a PNG file
    /// Called with null after each picture, and with the film so far after those of time and of a control.
    std::function<void(const Film*)> step;
};

/// Draws the film: each picture is the one that `glibra render` draws with --time or --set, and those over
/// time are drawn in order by one run. Controls are sliders, choices and check boxes; a slider has up to
/// seven values, and fewer if there are many sliders. Colours are choices of the plain colours, variables
/// without a range are choices of what keys give them, and one choice has the named cameras; other numbers
/// without a range are named by a note. Without a picture if the scene cannot be drawn. Reports
/// what loading and the first picture do, and page-W02 for what is left out.
Film filmOf(gpu::Context& context, const FilmTask& task, render::SharedParts* shared, const FilmParts& parts,
            Diagnostics& diagnostics);

// What a page of a scene is made of: every file that the scene reads, its picture, and whether browsers
// can draw it; if not, its film.

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

// Live pages, and those of films, as texts. Whatever a scene contains is data on them: no text of a scene
// becomes HTML or script, and the Content-Security-Policy lets only glibra's own script run. Equal scenes
// give equal bytes.

/// Samples per pixel of a canvas, as those of glibra's window.
inline constexpr int kPageSamples = 4;

/// How a page begins.
struct PageOptions {
    bool isEmbedded = false;         ///< for a frame of another page: nothing but the scene and its controls
    bool hasPoster = false;          ///< the picture stands there until it is clicked
    std::vector<std::string> set{};  ///< "NAME=VALUE"
    double time = 0;                 ///< seconds
    int width = 0, height = 0;       ///< of the canvas; 0: the scene's window
    int samples = kPageSamples;      ///< per pixel, limited to the browser's maximum
};

/// The runtime of live pages, glibra.wasm, packed for them. It is looked for where the modules are, and in a
/// build tree in `web` beside the program's folder. page-E01: it is not installed.
Result<std::string> packedRuntime(
    const std::vector<std::filesystem::path>& folders = image::defaultModuleFolders());

/// The bytes packed by gzip, in base64.
std::string packed(std::span<const std::byte> bytes);

/// Names a file as pages do, by one of the names of `files`: where it is on this machine is nobody's
/// business.
void nameAsOnPage(Place& place, const auto& files) {
    for (const auto& each : files)
        if (place.file.ends_with("/" + each.name)) place.file = each.name;
    if (const std::filesystem::path path(place.file); path.is_absolute())
        place.file = path.filename().generic_string();
}

/// True if the page has the scene's film.
inline bool isFilm(const PageScene& scene) {
    return !scene.isLive && !scene.film.pictures.empty();
}
/// What the page of a scene that is not live says: that it is a film or a picture, the first message why, and
/// what it cannot do.
std::string whyNotLive(const PageScene& scene);

/// A page that needs no other file. `title` is the text of its heading. Of a scene that is not live it has
/// the film, or the picture alone; it then needs no runtime.
std::string wholePage(const PageScene& scene, const PageOptions& options, const std::string& title,
                      std::string_view runtime);

// The parts of a site whose pages share one runtime.

struct SiteFile {
    std::string name;
    std::string content;
};
/// "live.css", "live.js" and, unless the runtime is empty, "runtime.js", for one folder.
std::vector<SiteFile> runtimeFiles(std::string_view runtime);
/// What a scene is made of, as a script that its page loads.
std::string sceneScript(const PageScene& scene, const PageOptions& options);
/// The HTML of a scene on its page: the picture, in whose place the scripts put the scene. `folder` is that
/// of the runtime, `script` the file of sceneScript(), `picture` that of the picture, `whyFilm` is
/// whyNotLive() of a film; empty: the scene is live.
std::string liveHtml(std::string_view folder, std::string_view script, std::string_view picture, int width,
                     int height, const std::string& whyFilm);
/// What the pages of a site state as their Content-Security-Policy, as the content of an attribute.
inline constexpr std::string_view kSitePolicy =
    "default-src 'none'; img-src 'self' file: data: blob:; style-src 'self' file:; script-src 'self' file: "
    "'wasm-unsafe-eval'; base-uri 'none'; form-action 'none'";

/// The comment of a scene, without its ids, a paragraph for each run of lines; and `facts` in small letters.
std::string textHtml(const source::SceneHead& head, std::string_view facts);

}  // namespace glibra::page
