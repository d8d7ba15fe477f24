#include "view/window/panels/label_overlay.h"

#include <glad/gl.h>
#include <imgui.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "image/image.h"
#include "render/file/labels.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

/// Draws the block into a texture, unless the texture has it already.
void updateTexture(const gpu::Capabilities& capabilities, const render::LabelBlock& block,
                   LabelOverlay& overlay) {
    if (overlay.texture && overlay.scale == block.scale && overlay.lines == block.lines) return;
    image::Image picture{block.width, block.height, 4, image::Component::u8, {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(picture.height));
    render::drawLabels(picture, block, 0, 0);
    Result<gpu::Texture> made =
        gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {block.width, block.height, 1}, {picture.data, 4});
    overlay = {block.lines, block.scale, std::move(made.value)};
    if (!overlay.texture) return;
    glBindTexture(GL_TEXTURE_2D, overlay.texture->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

void labelOverlay(Ui& ui, LabelOverlay& overlay) {
    ui.session.setLabels(ui.shared.showLabels ? ui.settings.labelCorner : LabelCorner::none);
    if (!ui.shared.showLabels || !ui.session.hasScene()) return;
    const render::LabelBlock block = render::labelBlock(ui.session.width(), ui.session.height(),
                                                        ui.session.live().labels(), ui.settings.labelCorner);
    if (block.lines.empty()) return;
    updateTexture(ui.context.capabilities(), block, overlay);
    if (!overlay.texture) return;
    // The picture is blitted pixel by pixel; so is the block.
    const float pixels = ImGui::GetIO().DisplayFramebufferScale.x;  // per unit of the screen
    const ImVec2 at((std::round(ui.frame.picture[0] * pixels) + static_cast<float>(block.left)) / pixels,
                    (std::round(ui.frame.picture[1] * pixels) + static_cast<float>(block.top)) / pixels);
    const ImVec2 end(at.x + static_cast<float>(block.width) / pixels,
                     at.y + static_cast<float>(block.height) / pixels);
    ImGui::GetBackgroundDrawList()->AddImage(
        std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(overlay.texture->id())), at, end);
}

}  // namespace glibra::view
