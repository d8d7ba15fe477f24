#pragma once
// Draws a scene as a debug view.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "render/live/live_scene.h"
#include "view/debug_view/debug_program.h"

namespace glibra::view {

/// The default length of the lines along normals, as a fraction of half the picture's height.
inline constexpr double kUsualNormalLength = .08;

class DebugRenderer {
  public:
    /// For the scene in its current state: make a new renderer after a reload. Programs are kept between
    /// frames.
    DebugRenderer(gpu::Context& context, render::LiveScene& scene) : context_(context), scene_(scene) {}

    struct Request {
        DebugView kind = DebugView::facing;  ///< not `picture`
        double normalLength = kUsualNormalLength;
        double time = 0;
        bool axes = false;  ///< with normals only
        int layer = 0;      ///< of drawPass(), for a pass into several layers
    };
    /// Draws the debug view into `picture`. Draws that it cannot show are left out, with the warning view-W01
    /// once per program.
    Diagnostics draw(const gpu::Target& picture, const ViewState& view, const Request& request);
    /// Draws the debug view of one pass (index into NodeList::passes), in the size of what it draws into, and
    /// tests against its own depth. numbers() has the result; normals are colours there. `width` and `height`
    /// are those of the window. Returns why there is none; empty on success.
    std::string drawPass(std::size_t pass, int width, int height, const Request& request);
    /// Call it after the scene was planned again: forgets what was made for the plan.
    void forgetPlan() { drawn_.clear(); }
    /// The numbers of the last frame, bottom row first; empty for normals.
    [[nodiscard]] const TexelImage& numbers() const { return numbers_; }

  private:
    /// A program, with the vertices of the draw that was drawn with it last. Both are empty if the debug view
    /// cannot show the draw.
    struct Drawn {
        std::optional<DebugProgram> program;
        std::vector<gpu::Buffer> buffers;
        std::optional<gpu::VertexArray> vertices;
    };
    const Drawn& drawn(const plan::PlannedDraw& draw, DebugView kind, DebugStages stages);
    [[nodiscard]] render::ViewMatrices viewOf(const plan::PlannedDraw& draw) const;
    void connect(const plan::PlannedDraw& draw, Drawn& drawn);
    void bind(const plan::PlannedDraw& draw, const Drawn& drawn, const Request& request);
    void beginNumbers(const plan::PlannedDraw& draw, const Request& request, DebugStages stages);
    void drawNormals(const plan::PlannedDraw& draw, const Request& request, bool begins);
    Diagnostics show(const gpu::Target& picture, DebugView kind) const;

    gpu::Context& context_;
    render::LiveScene& scene_;
    std::map<std::tuple<DebugView, DebugStages, plan::PlannedProgramIndex, plan::PlannedMeshIndex>, Drawn>
        drawn_;
    std::set<std::pair<DebugView, plan::PlannedProgramIndex>> told_;
    Diagnostics remarks_;
    std::optional<gpu::Target> target_;
    TexelImage numbers_;
    int width_ = 1, height_ = 1;
};

}  // namespace glibra::view
