#pragma once
// The state of the window "Textures, targets, buffers", and its view of a buffer.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plan/buffers.h"
#include "render/check/object_content.h"
#include "scene/objects.h"
#include "view/window/panels/texel_view.h"

namespace glibra::view {

struct Ui;

struct Inspector {
    /// "picture", "depth", the name of a texture or buffer, or "#2" for texture 2 of the scene, which has no
    /// name.
    std::string chosen = "picture";
    int level = 0, layer = 0;
    bool isPrevious = false;  ///< the other copy of an object with history
    bool wasOpen = false;     ///< in the last frame
    TexelView view;
    std::string readFor;  ///< what `content` or `rows` was read for
    std::optional<render::Content> content;
    std::string problem;  ///< why there is none
    // Of a buffer:
    std::uint64_t firstRow = 0;
    plan::BufferTable table;
    std::vector<std::string> head;               ///< the cells before the array
    std::vector<std::vector<std::string>> rows;  ///< the cells of the shown elements
};

/// Reads the shown elements of a buffer.
void readBuffer(const Ui& ui, Inspector& inspector, scene::BufferIndex index);
/// Draws the buffer's members and elements as tables.
void bufferTable(Ui& ui, Inspector& inspector);

}  // namespace glibra::view
