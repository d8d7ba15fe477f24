// Lines that are wider than the driver draws them.

#include <fmt/format.h>

#include <utility>

#include "render/draw/frame.h"
#include "render/load/gl_names.h"

namespace glibra::render {

bool FrameDrawer::drawsEdges(const plan::PlannedDraw& planned) const {
    return context_.capabilities().isEs &&
           (wireframe_ || plan_.drawOf(planned).raster->polygon == base::PolygonMode::line);
}

bool FrameDrawer::drawsLines(const plan::PlannedDraw& planned, const BuiltProgram& built) const {
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    if (expanded.corners > 0)
        return expanded.ofPrimitive == 2 || (expanded.ofPrimitive == 3 && drawsEdges(planned));
    const GLenum mode = glMode(planned.submission);
    return mode == GL_LINES || mode == GL_LINE_STRIP || mode == GL_LINE_LOOP ||
           (mode != GL_POINTS && drawsEdges(planned));
}

void FrameDrawer::widenLines(const plan::PlannedDraw& planned, const BuiltProgram& built,
                             const PassInProgress& pass, base::RasterState& raster,
                             Diagnostics& diagnostics) {
    wide_.reset();
    const gpu::Capabilities& capabilities = context_.capabilities();
    const scene::Draw& draw = plan_.drawOf(planned);
    const double widest = capabilities.widestLine();
    if (raster.lineWidth <= widest || (capabilities.isEs && !drawsLines(planned, built))) return;
    // A hook may draw with a program of its own.
    if (built.interface.facts.wideLines.captured.empty() || hook_ || raster.discard || draw.verticesFrom ||
        draw.instancesFrom) {
        if (!std::exchange(lineWidthReported_, true))
            diagnostics.push_back(
                diagnose("draw-W04", fmt::format("LineWidth {:g} limited to {:g}", raster.lineWidth, widest),
                         draw.place));
        return;
    }
    const gpu::PixelRectangle port =
        gpu::pixelsOf(raster.viewport, pass.target.width(), pass.target.height());
    auto mode = glsl::WideMode::fromMinusW;
    if (raster.depthOrder == base::DepthOrder::reversed && capabilities.clipControl)
        mode = glsl::WideMode::fromZero;
    if (raster.depthClamp && capabilities.hasExtension("GL_EXT_depth_clamp"))
        mode = glsl::WideMode::depthClamped;
    wide_ = LineWidener::Look{.draw = &planned,
                              .built = &built,
                              .viewportWidth = static_cast<double>(port.width),
                              .viewportHeight = static_cast<double>(port.height),
                              .lineWidth = raster.lineWidth,
                              .hasSamples = pass.target.samples() > 1,
                              .mode = mode,
                              .vertices = &device_.vertexArray(plan_, planned, built),
                              .bindAgain = [this, &planned] { bindWorkUnit(planned); }};
    // Lines are in front, are not culled, and have no offset.
    raster.cull = base::Cull::off;
    raster.front = base::Winding::ccw;
    raster.offsetFactor = raster.offsetUnits = 0;
}

QuadDrawer FrameDrawer::quads() const {
    if (!wide_) return {};
    return [this](GLenum mode, int vertices, int instances) {
        return widener_.draw(*wide_, {.count = vertices, .mode = mode, .instances = instances});
    };
}

void FrameDrawer::bindWorkUnit(const plan::PlannedDraw& planned) const {
    for (const plan::TextureUse& each : planned.textures)
        if (each.driverUnit == gpu::kWorkUnit) device_.bind(each, bindings_);
}

}  // namespace glibra::render
