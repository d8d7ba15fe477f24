#pragma once
// What the command lines of `glibra gallery` and of `glibra publish` for several scenes state.

#include <string>
#include <vector>

#include "cli/picture_options.h"
#include "page/page.h"

namespace glibra::cli {

struct GalleryArguments {
    std::string folder;
    std::vector<std::string> scenes{};  ///< below the folder; empty: all
    std::string title;
    SiteOptions made{.site = "glibra-gallery"};
    bool isLive = false;
    page::PageOptions page{};  ///< of live scenes
    page::FilmOptions film{};  ///< of the others
};

/// Makes the site and prints what went wrong. Returns the exit status.
int makeGallery(const GalleryArguments& arguments);

}  // namespace glibra::cli
