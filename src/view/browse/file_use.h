#pragma once
// What a scene does with a file.

#include <filesystem>

#include "view/scene/live_scene.h"

namespace glibra::view {

struct FileUse {
    enum class Kind {
        none,
        text,     ///< the scene itself, a shader, an included file
        texture,  ///< on the device
        data      ///< a model, or a texture that nothing visible samples
    };
    Kind kind = Kind::none;
    scene::TextureIndex texture{};
    Place place;  ///< the text's first line; of textures and data, the statement that names it
};

/// Files are the same if their names lead to the same file.
FileUse useOf(const LiveScene& live, const std::filesystem::path& file);

}  // namespace glibra::view
