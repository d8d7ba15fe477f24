#pragma once
// The values over the picture on the screen: the same pixels as in hardcopies.

#include <optional>
#include <string>
#include <vector>

#include "gpu/object/texture.h"
#include "render/live/knobs.h"

namespace glibra::view {

struct Ui;

struct LabelOverlay {
    std::vector<std::string> lines;  ///< in `texture`
    int scale = 0;
    std::optional<gpu::Texture> texture;
};

/// How Ui::labelled names a value.
std::string labelKey(const render::Knob& knob);
/// A menu of which values are labelled.
void labelChoice(Ui& ui, const char* id, const char* name, float width);
/// Draws the values over the picture, if they are wanted.
void labelOverlay(Ui& ui, LabelOverlay& overlay);

}  // namespace glibra::view
