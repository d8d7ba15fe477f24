#pragma once
// The values of uniform variables as text over a picture (RenderOptions::labels).

#include <glibra/render.h>

#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::render {

/// The name of a program for users: "Dots", or "Dots (2)" for the second of that name.
std::string titleOf(const scene::Scene& scene, scene::ProgramIndex program);

/// A line for each variable of the scene, "size = 0.5000", and for each value that its programs are given,
/// in the order of the scene: "OvalNoise : uAd = 0.0500", "OvalNoise : uUseChromaDepth = false",
/// "OvalNoise : uColor = 0.9000 0.5000 0.2000". Units of textures are left out.
std::vector<std::string> labelsOf(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans);

/// Where a block of labels lies in a picture, in pixels from the upper left corner.
struct LabelBlock {
    int left = 0, top = 0, width = 0, height = 0;
    int scale = 1;  ///< size of the letters, see image::drawText
    std::vector<std::string> lines;
};

/// The block in a picture of that size. Letters grow with the picture: they are 16 pixels high, and twice as
/// high from 1080 rows on. If there are more lines than fit, the last one says how many are left out.
LabelBlock labelBlock(int width, int height, std::vector<std::string> lines, LabelCorner corner);

/// Draws the block at a place of the picture: its own one, or 0, 0 of a picture that holds the block alone.
void drawLabels(image::Image& picture, const LabelBlock& block, int left, int top);

}  // namespace glibra::render
