#include "view/window/panels/label_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "image/image.h"
#include "render/draw/axes.h"
#include "view/window/panels/shown_texture.h"
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
    overlay = {block.lines, block.scale,
               textureOfBytes(capabilities, block.width, block.height, picture.data, GL_NEAREST, GL_NEAREST)};
}

/// Finds the values to label; none in `only`: all. Returns false if there are none.
bool hasLabels(const Ui& ui, std::vector<std::string>& only) {
    if (ui.settings.labelChoice == LabelChoice::all) return true;
    const std::vector<render::Knob>& knobs = ui.session.knobs();
    for (const render::Knob& each : knobs)
        if (ui.settings.labelChoice == LabelChoice::changed ? each.isChanged()
                                                            : ui.labelled.contains(labelKey(each)))
            only.push_back(labelBegin(each));
    return !only.empty();
}

}  // namespace

std::string labelKey(const render::Knob& knob) {
    return knob.title + "/" + knob.tag;
}

void labelChoice(Ui& ui, const char* id, const char* name, float width) {
    constexpr std::array kChoices{std::pair{LabelChoice::all, "all"},
                                  std::pair{LabelChoice::changed, "changed"},
                                  std::pair{LabelChoice::chosen, "chosen"}};
    ImGui::SetNextItemWidth(width);
    if (beginCombo(ui, id, kChoices.at(static_cast<std::size_t>(ui.settings.labelChoice)).second, name)) {
        for (const auto& [which, words] : kChoices)
            if (choice(ui, words, which == ui.settings.labelChoice, "{}/{}", name, words))
                ui.settings.labelChoice = which;
        ImGui::EndCombo();
    } else {
        tooltip(
            "Which values are labelled: all, those that differ from the scene's,\n"
            "or those that 'Label on the picture' in the menu of a value chooses");
    }
}

void labelOverlay(Ui& ui, LabelOverlay& overlay) {
    std::vector<std::string> only;
    const bool isShown = ui.shared.showLabels && ui.session.hasScene() && hasLabels(ui, only);
    ui.session.setLabels(isShown ? ui.settings.labelCorner : LabelCorner::none, only);
    if (!isShown) {
        overlay = {};
        return;
    }
    const render::LabelBlock block = render::labelBlock(
        ui.session.width(), ui.session.height(), ui.session.live().labels(only), ui.settings.labelCorner);
    if (block.lines.empty()) return;
    updateTexture(ui.context.capabilities(), block, overlay);
    if (!overlay.texture) return;
    // The picture is blitted pixel by pixel; so is the block.
    const float pixels = ImGui::GetIO().DisplayFramebufferScale.x;  // per unit of the screen
    ImVec2 at((std::round(ui.frame.picture[0] * pixels) + static_cast<float>(block.left)) / pixels,
              (std::round(ui.frame.picture[1] * pixels) + static_cast<float>(block.top)) / pixels);
    // Beside a source that stands over the picture.
    if (at.x < ui.frame.covered)
        at.x = std::max(at.x, std::min(std::round(ui.frame.covered + 4 * ui.shared.scale),
                                       ui.frame.picture[0] + ui.frame.picture[2] -
                                           static_cast<float>(block.width) / pixels));
    const ImVec2 end(at.x + static_cast<float>(block.width) / pixels,
                     at.y + static_cast<float>(block.height) / pixels);
    ImGui::GetBackgroundDrawList()->AddImage(idOf(*overlay.texture), at, end);
}

}  // namespace glibra::view
