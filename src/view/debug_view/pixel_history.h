#pragma once
// Which draws touch a pixel of a pass, in order: how many fragments each has there, which tests they pass,
// and what is there afterwards.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "render/live/live_scene.h"
#include "view/debug_view/frame_items.h"

namespace glibra::view {

/// What a pixel holds.
struct PixelState {
    std::vector<double> color;  ///< of one colour output, as many components as it has; empty: there is none
    std::optional<double> depth;
    std::optional<int> stencil;
    friend bool operator==(const PixelState&, const PixelState&) = default;
};

struct PixelEvent {
    enum class Outcome {
        begins,      ///< the pass begins, with its clear if it has one
        clears,      ///< a Clear in the pass
        passed,      ///< at least one fragment passed all tests
        depthFails,  ///< of all fragments
        stencilFails,
        discarded,  ///< by the fragment stage
        culled,     ///< the side of the face that the state leaves out
        unknown,    ///< its shaders store to memory, so that they run only once; the pixel has changed
    };
    std::size_t item = 0;  ///< of the list
    Outcome outcome = Outcome::passed;
    std::uint64_t fragments = 0;  ///< that the fragment stage has left at the pixel
    std::uint64_t passed = 0;     ///< of them, those that pass the tests against what was there before
    PixelState before, after;
};

struct PixelHistory {
    std::vector<PixelEvent> events;
    std::size_t untouched = 0;  ///< draws of these passes that have nothing at the pixel
    std::string problem;        ///< why there is no history
};

/// "drawn", "hidden: the depth test fails", and so on.
std::string_view wordsOf(PixelEvent::Outcome outcome);

/// The history of a pixel of the targets of that pass, a draw of it or a clear in it (`item`), through all
/// passes of the frame into the same targets. `width` and `height` are those of the window. `output`: the
/// colour output whose colours are reported.
PixelHistory pixelHistory(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
                          std::size_t item, int width, int height, double time, const TargetPixel& pixel,
                          int output);

}  // namespace glibra::view
