#pragma once
// The list of what a frame executes: its passes with their draws and clears, its dispatches, and its clears
// of objects, in order. There is no GL here.

#include <glibra/diagnostic.h>
#include <glibra/draw_id.h>

#include <cstddef>
#include <string>
#include <vector>

#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::view {

/// Something that is drawn into, or that shaders write.
struct FrameTarget {
    enum class Kind { color, depth, stencil, texture, buffer };
    Kind kind = Kind::color;
    int output = 0;               ///< of a colour: the colour output of the pass
    std::string name;             ///< "window", "shadows layer 2", "depth"
    scene::TextureView view{};    ///< none: of the window, or a depth buffer that no texture holds
    scene::BufferIndex buffer{};  ///< of a buffer
};

struct FrameItem {
    enum class Kind { pass, draw, clear, dispatch, clearObject };
    Kind kind = Kind::pass;
    std::size_t node = 0;     ///< index into FramePlan::order
    scene::StepIndex step{};  ///< of a draw or a clear in a pass; its `pass` also for a pass
    Place place;
    std::string title;                 ///< "pass into window", "Sphere", "Clear", "dispatch of Move"
    std::string program;               ///< of a draw or dispatch; empty: the built-in one
    std::vector<FrameTarget> targets;  ///< of a draw or a clear: those of its pass
    /// Tells the items of a frame apart, and stays when statements around it change: "draw 54:0".
    std::string key;
    int number = 0;  ///< among the draws of its pass with that title and line, from 1; 0: it is the only one

    [[nodiscard]] bool isInPass() const { return kind == Kind::draw || kind == Kind::clear; }
    /// True for what `step` is of.
    [[nodiscard]] bool hasPass() const { return kind == Kind::pass || isInPass(); }
};

/// A pixel of what a pass draws into. x and y count from the lower left corner.
struct TargetPixel {
    int x = 0, y = 0;
    int layer = 0;  ///< or face, where the pass draws into several at once
};

std::vector<FrameItem> frameItems(const scene::Scene& scene, const plan::FramePlan& plan);

/// True if both passes draw into the same textures, or both into the window.
bool haveSameTargets(const scene::Pass& a, const scene::Pass& b);

}  // namespace glibra::view
