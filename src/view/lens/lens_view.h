#pragma once
// Draws a scene through a lens.

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/target.h"
#include "gpu/vertex_array.h"
#include "view/lens/lens.h"
#include "view/lens/lens_program.h"
#include "view/scene/live_scene.h"

namespace glibra::view {

/// Length of the lines along normals, as a part of half the picture's height, at first.
inline constexpr double kUsualNormalLength = .08;

class LensView {
  public:
    /// For this scene as it is now; programs made for it are kept.
    LensView(gpu::Context& context, LiveScene& scene) : context_(context), scene_(scene) {}

    struct Request {
        Lens lens = Lens::facing;  ///< not `picture`
        double normalLength = kUsualNormalLength;
        double time = 0;
        bool axes = false;  ///< with normals only
    };
    /// Puts the colours into `picture`. Draws that the lens cannot show are left out; view-W01 says it, once
    /// a program.
    Diagnostics draw(const gpu::Target& picture, const ViewState& view, const Request& request);
    /// Of the frame drawn last, bottom row first; empty for normals.
    [[nodiscard]] const TexelImage& numbers() const { return numbers_; }

  private:
    /// A program with the vertices of one mesh.
    struct Drawn {
        std::optional<LensProgram> program;
        std::vector<gpu::Buffer> buffers;
        std::optional<gpu::VertexArray> vertices;
    };
    const Drawn& drawn(const plan::PlannedDraw& draw, Lens lens, LensStages stages);
    void connect(const plan::PlannedDraw& draw, Drawn& drawn);
    void bind(const plan::PlannedDraw& draw, const Drawn& drawn, const Request& request);
    void beginNumbers(const plan::PlannedDraw& draw, const Request& request, LensStages stages);
    void drawNormals(const plan::PlannedDraw& draw, const Request& request, bool begins);
    Diagnostics show(const gpu::Target& picture, Lens lens) const;

    gpu::Context& context_;
    LiveScene& scene_;
    std::map<std::tuple<Lens, LensStages, plan::PlannedProgramIndex, plan::PlannedMeshIndex>, Drawn> drawn_;
    std::map<std::pair<Lens, plan::PlannedProgramIndex>, bool> told_;
    Diagnostics remarks_;
    std::optional<gpu::Target> target_;
    TexelImage numbers_;
    int width_ = 1, height_ = 1;
};

}  // namespace glibra::view
