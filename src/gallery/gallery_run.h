#pragma once
// Draws and describes the scenes of a folder in worker processes, and writes the site. A scene that crashes
// the driver, hangs or takes all memory affects only itself.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gallery/gallery.h"
#include "page/page.h"
#include "suite/run/run_options.h"

namespace glibra::gallery {

struct GalleryPlan {
    std::string title;
    std::filesystem::path folder;
    std::vector<std::filesystem::path> scenes;  ///< below the folder, with it, in the order of the pages
    std::filesystem::path site;
    int width = 0, height = 0;  ///< pictures keep the shape of their windows and fit into this
    std::vector<std::filesystem::path> libraryRoots;
    struct Live {
        page::PageOptions page;
        std::string runtime;  ///< page::packedRuntime()
        page::FilmOptions film{};
    };
    /// Scenes that browsers can draw run on their pages, and of the others films with controls do.
    std::optional<Live> live{};
};

struct GalleryEvents {
    /// Called once, when it is known how many pictures and frames will be drawn.
    std::function<void(std::size_t pictures)> starts;
    std::function<void(const std::string& scene)> begins;
    std::function<void(bool failed)> done;  ///< of a picture or a frame
    std::function<bool()> stop;
};

struct GalleryEnd {
    Gallery gallery;
    Diagnostics diagnostics;  ///< no driver (gpu-E01), or what cannot be written (file-E10)
    bool noDriver = false, stopped = false;
};

/// The length of a film, in frames, and its speed.
inline constexpr int kFilmFrames = 24;
inline constexpr double kFilmRate = 10;  ///< frames per second

/// Nothing, or why the site cannot be written there: the folder has files and is no gallery.
std::string whyNoSite(const std::filesystem::path& site);

/// Files of an earlier gallery are removed first, so that a run that is stopped leaves no page. Call it
/// before any thread or GL context exists.
GalleryEnd runGallery(const GalleryPlan& plan, const suite::SiteWorkers& workers,
                      const GalleryEvents& events);

}  // namespace glibra::gallery
