#pragma once
// The state of the window "Frame", and its parts: the list of what the frame executes, what the chosen item
// left, a pixel, the state and the mesh of a draw.

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gpu/object/texture.h"
#include "view/debug_view/debug_program.h"
#include "view/debug_view/draw_state.h"
#include "view/debug_view/frame_items.h"
#include "view/debug_view/frame_watch.h"
#include "view/debug_view/mesh_capture.h"
#include "view/debug_view/pixel_probe.h"
#include "view/window/panels/texel_view.h"

namespace glibra::view {

struct Ui;

struct FrameWindow {
    std::vector<FrameItem> items;
    using Texts = std::map<std::filesystem::path, std::string>;
    Texts texts;                           ///< of the files with the items, as the scene was read
    std::string chosen;                    ///< the key of an item; empty: none
    std::vector<std::string> folded;       ///< keys of the passes whose draws are not listed
    std::size_t target = 0;                ///< index into the targets of the chosen item
    int layer = 0;                         ///< of that target, if the pass draws into all of its layers
    DebugView shows = DebugView::picture;  ///< `picture`: what the target holds
    bool highlights = true;
    float upperPart = .6F;  ///< of the height, for the picture above the tabs

    std::string watchedFor, listedFor;  ///< what the following was made for
    FrameAnswer answer;
    std::vector<std::optional<gpu::Texture>> thumbnails;  ///< by item
    std::vector<bool> asked, isDrawn;  ///< by item: has been asked for a thumbnail; is executed by the frame
    std::optional<gpu::Texture> overlay;  ///< the pixels of the chosen draw
    TexelImage numbers;                   ///< of a debug view
    std::optional<render::Content> shownNumbers;
    std::vector<std::uint8_t> colors;
    std::string problem;
    double time = 0;  ///< of the frame that is listed
    TexelView view;
    /// The view begins anew with the next content; true: with the range that this has.
    std::optional<bool> begins;

    std::optional<std::pair<int, int>> pixel;  ///< of the targets, from the lower left corner
    std::string pixelFor, probedFor;
    PixelHistory history;
    std::optional<ProbedPixel> probed;  ///< of the chosen draw at that pixel

    std::string meshFor;
    std::vector<MeshStage> mesh;
    std::size_t meshStage = 0;
    float turn = 30, tilt = 20, distance = 1;  ///< degrees; how far the mesh is from the eye
    std::size_t firstRow = 0;

    /// GPU times of the items by their keys, as they were measured last.
    struct Times {
        int decimals = 3;
        bool isEstimate = false;
        std::map<std::string, double> milliseconds;
    } times;

    [[nodiscard]] bool isFolded(const std::string& key) const;
    /// The chosen item; null if there is none.
    [[nodiscard]] const FrameItem* item() const;
    [[nodiscard]] std::optional<std::size_t> index() const;
    /// The one of the item's targets that is chosen; null if it has none.
    [[nodiscard]] const FrameTarget* targetOf(const FrameItem& item) const;
    void choose(const FrameItem& item);
};

/// The draw of the plan that the item is; null for other items.
const plan::PlannedDraw* plannedDraw(const plan::FramePlan& plan, const FrameItem& item);

/// "Cylinder 2  Sunlit  line 34".
std::string labelOf(const FrameItem& item);
void frameList(Ui& ui, FrameWindow& window);

// The tabs below the picture.
void framePixel(Ui& ui, FrameWindow& window);
void frameState(Ui& ui, const FrameWindow& window);
void frameTrial(Ui& ui, const FrameWindow& window);
void frameMesh(Ui& ui, FrameWindow& window);

/// For `--state`.
nlohmann::ordered_json frameJson(const Ui& ui, const FrameWindow& window);

}  // namespace glibra::view
