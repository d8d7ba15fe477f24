#pragma once
// Draws a frame again: what each of its passes, dispatches and draws leaves, and which of them touch a pixel.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "render/check/object_content.h"
#include "render/live/live_scene.h"
#include "view/debug_view/frame_items.h"

namespace glibra::view {

/// A small picture of what is there after an item: opaque RGBA bytes, bottom row first. Empty: there is none.
struct FrameThumbnail {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// The pixels that a draw covers, bottom row first.
struct DrawMask {
    enum Kind : std::uint8_t {
        none = 0,
        hidden = 1,
        passed = 2
    };  ///< hidden: the depth or stencil test failed
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
    std::size_t passedPixels = 0, hiddenPixels = 0;
};

struct FrameQuestion {
    int width = 1, height = 1;  ///< of the window's picture
    double time = 0;
    std::vector<bool> thumbnails{};     ///< by item: wanted; empty: none is
    std::optional<std::size_t> item{};  ///< of the list: its target is read, and its mask is drawn
    std::size_t target = 0;             ///< index into its targets
    int layer = 0;                      ///< that is read where the pass draws into all layers of the target
};

struct FrameAnswer {
    /// By item; false: nothing of it can be seen, its program failed, or it was not asked for: without
    /// thumbnails, only the passes into the window are drawn if the item is of them.
    std::vector<bool> isExecuted;
    std::vector<FrameThumbnail> thumbnails;  ///< by item; empty if none is wanted
    std::optional<render::Content> content;  ///< of the target after the item
    int layers = 1;                          ///< of that target, if the pass draws into all of them
    std::string layerName;                   ///< "face -y": the one that is read, if there are several
    std::string problem;                     ///< why there is none
    std::optional<DrawMask> mask;            ///< of a draw, in that layer
};

inline constexpr int kThumbnailSide = 96;
/// More items have no thumbnails.
inline constexpr std::size_t kMostThumbnails = 400;

/// `items` are those of the scene's plan. The scene has been drawn in that size at that time
/// (LiveScene::look); nothing of it changes.
FrameAnswer watchFrame(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
                       const FrameQuestion& question);

// Which draws touch a pixel of a pass, in order: how many fragments each has there, which tests they pass,
// and what is there afterwards.

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
