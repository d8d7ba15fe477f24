#pragma once
// The film of a scene that browsers cannot draw: pictures over time, and over the values of each control.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "image/image.h"
#include "render/load/shared_parts.h"

namespace glibra::page {

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

}  // namespace glibra::page
