// The window that shows the texels of textures, targets and the picture.

#include <fmt/format.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <string>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr int kColor = -1;
constexpr int kDepth = -2;

scene::TextureIndex textureOf(int chosen) {
    return chosen < 0 ? scene::TextureIndex() : scene::TextureIndex(static_cast<std::size_t>(chosen));
}

std::string titleOf(const Ui& ui, int chosen) {
    if (chosen == kColor) return "picture: colour";
    if (chosen == kDepth) return "picture: depth";
    return textureTitle(ui.session.live().scene(), textureOf(chosen));
}

void choose(Ui& ui) {
    Inspector& inspector = ui.inspector;
    const auto count = static_cast<int>(ui.session.live().scene().textures.size());
    const auto isThere = [&](int each) {
        return each < 0 || (each < count && ui.session.live().texture(textureOf(each)));
    };
    if (!isThere(inspector.chosen)) inspector.chosen = kColor;
    ImGui::SetNextItemWidth(-1);
    const bool isOpen = ImGui::BeginCombo("##what", titleOf(ui, inspector.chosen).c_str());
    mark(ui, "inspector/what");
    if (!isOpen) return;
    for (int each = kDepth; each < count; ++each) {
        if (!isThere(each)) continue;
        ImGui::PushID(each);
        if (ImGui::Selectable(titleOf(ui, each).c_str(), each == inspector.chosen)) {
            inspector.chosen = each;
            inspector.slice = 0;
        }
        mark(ui, fmt::format("inspector/item/{}", each));
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// Reads the texels again after each frame of the scene, and after another choice.
void read(Ui& ui) {
    Inspector& inspector = ui.inspector;
    const gpu::Target* picture = ui.session.picture();
    if (!picture) return;
    const bool isSame = inspector.frame == ui.session.framesDrawn() &&
                        inspector.readChosen == inspector.chosen && inspector.readSlice == inspector.slice &&
                        inspector.readScene == ui.session.path();
    if (!isSame) {
        if (inspector.chosen == kColor)
            inspector.image = colorTexels(*picture);
        else if (inspector.chosen == kDepth)
            inspector.image = depthTexels(*picture);
        else
            inspector.image =
                texelsOf(*ui.session.live().texture(textureOf(inspector.chosen)), inspector.slice);
        inspector.frame = ui.session.framesDrawn();
        inspector.readChosen = inspector.chosen;
        inspector.readSlice = inspector.slice;
        inspector.readScene = ui.session.path().string();
    }
    if (inspector.image.rgba.empty()) return inspector.shown.reset();
    const std::vector<std::uint8_t> bytes = screenBytes(inspector.image, inspector.display);
    Result<gpu::Texture> made = gpu::Texture::create(
        ui.context.capabilities(), gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
        {inspector.image.width, inspector.image.height, 1}, {std::as_bytes(std::span(bytes)), 4});
    inspector.shown = std::move(made.value);
    if (!inspector.shown) return;
    glBindTexture(GL_TEXTURE_2D, inspector.shown->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void settings(Ui& ui) {
    Inspector& inspector = ui.inspector;
    ImGui::PushItemWidth(110 * ui.scale);
    int channels = static_cast<int>(inspector.display.channels);
    if (ImGui::Combo("##channels", &channels, "RGB\0red\0green\0blue\0alpha\0"))
        inspector.display.channels = static_cast<Channels>(channels);
    mark(ui, "inspector/channels");
    ImGui::SameLine();
    ImGui::SliderFloat("gain", &inspector.display.gain, .01F, 100, "%.2f", ImGuiSliderFlags_Logarithmic);
    markField(ui, "inspector/gain", "gain");
    ImGui::SameLine();
    ImGui::SliderFloat("zoom", &inspector.zoom, .1F, 32, "%.2f", ImGuiSliderFlags_Logarithmic);
    markField(ui, "inspector/zoom", "zoom");
    ImGui::PopItemWidth();
    const gpu::Texture* texture = ui.session.live().texture(textureOf(inspector.chosen));
    const int slices = texture ? sliceCount(*texture) : 1;
    if (slices > 1) {
        const char* label = texture->shape() == gpu::TextureShape::cube ? "face" : "slice";
        ImGui::SliderInt(label, &inspector.slice, 0, slices - 1);
        markField(ui, "inspector/slice", label);
    }
    inspector.slice = std::clamp(inspector.slice, 0, slices - 1);
}

void image(Ui& ui) {
    Inspector& inspector = ui.inspector;
    const TexelImage& texels = inspector.image;
    if (!inspector.shown) return ImGui::TextDisabled("The driver cannot read this format.");
    const NonFiniteTexels bad = countNonFinite(texels);
    ImGui::Text("%d x %d   %s", texels.width, texels.height, inspector.hovered.c_str());
    if (bad.nan + bad.infinite > 0)
        ImGui::TextColored({1, .4F, .9F, 1}, "%d texels are NaN (magenta), %d infinite (cyan)", bad.nan,
                           bad.infinite);
    ImGui::BeginChild("image", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(static_cast<float>(texels.width) * inspector.zoom,
                      static_cast<float>(texels.height) * inspector.zoom);
    ImGui::Image(std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(inspector.shown->id())), size, {0, 1},
                 {1, 0});
    mark(ui, "inspector/image");
    inspector.hovered.clear();
    if (ImGui::IsItemHovered()) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const int x = std::clamp(static_cast<int>((mouse.x - at.x) / inspector.zoom), 0, texels.width - 1);
        const int y = std::clamp(static_cast<int>((mouse.y - at.y) / inspector.zoom), 0, texels.height - 1);
        const auto row = static_cast<std::size_t>(texels.height - 1 - y);
        const float* texel = texels.rgba.data() +
                             4 * (row * static_cast<std::size_t>(texels.width) + static_cast<std::size_t>(x));
        inspector.hovered = fmt::format("{}, {}: {:.5g} {:.5g} {:.5g} {:.5g}", x, row, texel[0], texel[1],
                                        texel[2], texel[3]);
        ImGui::SetTooltip("%s", inspector.hovered.c_str());
    }
    ImGui::EndChild();
}

}  // namespace

void inspectorWindow(Ui& ui) {
    if (!ui.inspector.isOpen || !ui.session.hasScene()) return;
    placeFloating(ui, 20, 20, 520, 460);
    if (ImGui::Begin("Textures and targets", &ui.inspector.isOpen, ImGuiWindowFlags_NoCollapse)) {
        choose(ui);
        settings(ui);
        read(ui);
        image(ui);
    }
    ImGui::End();
}

}  // namespace glibra::view
