#pragma once
// Pixels as textures, for ImGui to draw.

#include <glad/gl.h>
#include <imgui.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/object/texture.h"
#include "render/check/object_content.h"
#include "view/debug_view/display_expression.h"
#include "view/debug_view/texels.h"

namespace glibra::view {

/// How ImGui names it.
ImTextureID idOf(const gpu::Texture& texture);

/// Bytes, `components` per texel, as a texture with these filters; nothing without memory. It stays bound.
std::optional<gpu::Texture> textureOfBytes(const gpu::Capabilities& capabilities, int width, int height,
                                           std::span<const std::byte> bytes, GLint minified, GLint magnified,
                                           int components = 4);

// Texels on the screen, as large as one likes: the range of values that is shown, the channels, zoom and pan,
// and the numbers under the mouse.

struct Ui;

struct TexelView {
    TexelDisplay display;
    bool wantsRange = false;  ///< the range of shown values follows from the next content
    bool fits = true;         ///< the zoom follows the size of the window, until the user chooses one
    float zoom = 1;
    std::string hovered;                         ///< the texel under the mouse: "12, 40: 0.5 0.25 0 1"
    std::optional<std::pair<int, int>> clicked;  ///< in this frame: a texel, from the lower left corner
    std::optional<std::pair<int, int>> marked;   ///< a ring is drawn around this texel
    std::optional<gpu::Texture> shown;

    bool asksForExpression = false;      ///< the field for it is open
    std::array<char, 256> expression{};  ///< GLSL (displayedBy); empty: the texels as they are
    Displayed displayed;                 ///< by the expression `displayedFor`
    std::string displayedFor;

    /// The content is another one: the texture is made anew.
    void forget() {
        shown.reset();
        displayed = {};
        displayedFor.clear();
    }
    /// For another object: its own range, the whole of it.
    void begin(bool withOwnRange);

    TexelDisplay shownDisplay;
    bool isDragged = false;  ///< since the button went down
};

struct TexelSource {
    const render::Content& content;  ///< bottom row first
    /// Opaque RGBA to show in its place; null: its values, or what the expression of the view makes of them.
    const std::vector<std::uint8_t>* colors = nullptr;
    /// The text about a texel (x, y, from the lower left corner); without it its numbers.
    std::function<std::string(int x, int y)> words{};
    const gpu::Texture* overlay = nullptr;  ///< of the same size, drawn over it
};

/// `name` begins the names of the widgets: "inspector".
void texelView(Ui& ui, TexelView& view, const TexelSource& source, std::string_view name);

/// Draws it at that place (left, top, width, height in screen coordinates) of the current window.
void drawTexture(const gpu::Texture& texture, const std::array<float, 4>& at);

/// Opaque or transparent RGBA bytes, bottom row first, as a texture that is magnified without filtering;
/// nothing without memory.
std::optional<gpu::Texture> textureOfTexels(const Ui& ui, int width, int height,
                                            std::span<const std::uint8_t> rgba);

}  // namespace glibra::view
