#pragma once
// The state of the window with the example scenes and their pictures.

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/object/texture.h"
#include "view/browse/example_scenes.h"
#include "view/browse/thumbnail_maker.h"
#include "view/browse/thumbnails.h"

namespace glibra::view {

struct ExampleBrowser {
    struct Tile {
        ExampleScene scene;
        Thumbnail thumbnail;
        std::optional<gpu::Texture> picture;  ///< loaded when the tile is first visible
    };

    bool isOpen = false;
    bool isListed = false;  ///< `tiles` is up to date
    std::filesystem::path root;
    std::vector<Tile> tiles;
    std::array<char, 128> search{};
    std::vector<std::string> chapters;                   ///< of the tiles
    std::string chapter;                                 ///< the one whose scenes are shown; empty: all
    std::size_t found = 0;                               ///< number of tiles that the search finds
    std::optional<std::vector<ExampleScene>> templates;  ///< of the menu "New", listed when it is first open
    std::unique_ptr<ThumbnailMaker> maker;
    std::size_t wanted = 0, finished = 0;  ///< numbers of pictures that the maker has to make, and has made
};

}  // namespace glibra::view
