#pragma once
// Finds out how a scene uses a file.

#include <filesystem>

#include "render/live/live_scene.h"

namespace glibra::view {

struct FileUse {
    enum class Kind {
        none,
        text,     ///< the scene itself, a shader or an included file
        texture,  ///< a texture on the device
        data      ///< a model, or a texture that no visible object samples
    };
    Kind kind = Kind::none;
    scene::TextureIndex texture{};
    Place place;  ///< the first line of a text; the statement that names a texture or data file
};

/// Links are followed: two names of the same file are equal.
FileUse useOf(const render::LiveScene& live, const std::filesystem::path& file);

}  // namespace glibra::view
