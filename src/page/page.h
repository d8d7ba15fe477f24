#pragma once
// Live pages, and those of films, as texts. Whatever a scene contains is data on them: no text of a scene
// becomes HTML or script, and the Content-Security-Policy lets only glibra's own script run. Equal scenes
// give equal bytes.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/module_loader.h"
#include "page/page_scene.h"

namespace glibra::page {

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
