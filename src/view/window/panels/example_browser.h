#pragma once
// The window with the example scenes and their pictures.

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/texture.h"
#include "view/browse/example_scenes.h"
#include "view/browse/thumbnails.h"
#include "view/window/thumbnail_maker.h"

namespace glibra::view {

struct ExampleBrowser {
    struct Tile {
        ExampleScene scene;
        Thumbnail thumbnail;
        std::optional<gpu::Texture> picture;  ///< once it was seen
    };

    bool isOpen = false;
    bool isListed = false;  ///< `tiles` is what is on the disk
    std::filesystem::path root;
    std::vector<Tile> tiles;
    std::array<char, 128> search{};
    std::unique_ptr<ThumbnailMaker> maker;
    std::size_t wanted = 0, finished = 0;  ///< pictures that the maker was asked for, and has made
};

}  // namespace glibra::view
