#pragma once
// What the fragment that is visible at a pixel has: its inputs, its outputs and the uniforms of its draw. The
// scene's own stages compute it: the pixel is drawn again, once for every four numbers, with a fragment stage
// that also writes them into a float target.

#include <glibra/draw_id.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "render/live/live_scene.h"
#include "view/debug_view/frame_items.h"

namespace glibra::view {

struct ProbedValue {
    std::string name;             ///< as the user wrote it: "vST", "uLights[1].color"
    std::string type;             ///< GLSL word
    std::vector<double> numbers;  ///< by component, then column, then element; empty if they are not known
    std::string why{};            ///< why they are not known
};

struct ProbedPixel {
    int x = -1, y = -1;     ///< of the picture; x counts to the right, y downwards
    int height = 0;         ///< of the picture
    bool isHidden = false;  ///< of a given draw: its fragments fail the depth or stencil test
    bool isDrawn = false;   ///< false: no fragment is visible there, and the rest is empty
    DrawId draw{};
    std::string word;     ///< the command that draws it
    std::string program;  ///< the name of its program; empty: the built-in one
    double depth = 1;     ///< window depth, 0 to 1
    bool isFront = true;  ///< the fragment is on the front side
    std::vector<ProbedValue> outputs;
    std::vector<ProbedValue> inputs;    ///< those that the stage before writes
    std::vector<ProbedValue> uniforms;  ///< outside blocks, without samplers; arrays up to 16 elements
    /// The value of that name in any of the three lists; null if there is none.
    [[nodiscard]] const ProbedValue* find(std::string_view name) const;
};

/// Probes a pixel of the frame that was drawn last, in a picture of that size at that time. Integers above
/// 2^24 are rounded to a float.
ProbedPixel probePixel(gpu::Context& context, render::LiveScene& scene, int width, int height, double time,
                       int x, int y);

/// The same for what one draw (of the frame's node list) has at a pixel of the targets of its pass, also
/// where something hides it.
ProbedPixel probeDraw(gpu::Context& context, render::LiveScene& scene, scene::StepIndex step, int width,
                      int height, double time, const TargetPixel& pixel);

/// The row of the pixel as gl_FragCoord counts it, from the lower edge.
inline int rowOf(const ProbedPixel& pixel) {
    return pixel.height - 1 - pixel.y;
}

/// "0.5 -1 2": the numbers with six digits, those of a matrix as lines with its rows; "true" or
/// "false"; or why they are not known.
std::string numbersText(const ProbedValue& value);

}  // namespace glibra::view
