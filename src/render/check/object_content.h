#pragma once
// Reads textures and buffers of a scene from the device as numbers.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/load/device_scene.h"
#include "scene/scene.h"

namespace glibra::render {

// What a picture, a texture or a buffer holds, as numbers.

/// Texels in rows from bottom to top, like gl_FragCoord, and layers after one another; or the elements of a
/// buffer, one per column.
struct Content {
    std::string name;  ///< for messages: "window", "life", "glow.level(2)"
    int width = 0, height = 1, depth = 1;
    int components = 4;
    double step = 0;  ///< the distance of neighbouring values of a normalised format; 0: exact values
    std::vector<double> values;
    bool isCube = false;       ///< the layers are faces
    bool isOfDoubles = false;  ///< the values are doubles, not floats or integers

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(depth);
    }
    /// The components of an element, counted from 0.
    [[nodiscard]] std::span<const double> at(std::size_t index) const {
        return std::span(values).subspan(index * static_cast<std::size_t>(components),
                                         static_cast<std::size_t>(components));
    }
};

/// The content of a texture, a part of it, or a buffer. Textures of integers give the integers, depth
/// textures one component. Makes the mipmaps if a level above 0 is read. Reports check-E02 with the reason
/// for what cannot be read.
Result<Content> contentOf(const scene::Scene& scene, DeviceScene& device, const scene::ObjectView& object);

/// The content of one level of a texture without samples, in all layers or one; level and layer must exist.
Result<Content> contentOf(const gpu::Texture& texture, int level, std::optional<int> layer);

}  // namespace glibra::render
