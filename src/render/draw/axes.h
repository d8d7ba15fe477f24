#pragma once
// What is drawn over a picture: axes and labels.

#include <glibra/render.h>
#include <glibra/result.h>

#include <span>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/draw/view_matrices.h"
#include "scene/scene.h"

namespace glibra::render {

// --axes: three axes with the letters X, Y and Z at their ends, as glman draws them: kAxisLength units long,
// white and thick.

inline constexpr double kAxisLength = 1.5;       ///< units of world space
inline constexpr double kAxisWidth = 1.0 / 200;  ///< of the lines, as a part of the picture's height
inline constexpr double kLeastAxisWidth = 1.5;   ///< pixels

class Axes {
  public:
    /// The context must outlive them.
    static Result<Axes> create(const gpu::Context& context);

    /// Draws into the target, which shows `tile` of a picture of that size, with the projection of the
    /// scene's last draw into the window and the world's view. Whatever is nearer hides the axes.
    void draw(const gpu::Target& target, const scene::Scene& scene, const ViewMatrices& view,
              const Tile& tile, int width, int height) const;

  private:
    Axes(const gpu::Capabilities& driver, gpu::Program program, gpu::Buffer vertices, gpu::VertexArray lines,
         int count);

    const gpu::Capabilities* driver_;
    gpu::Program program_;
    GLint matrix_, part_, half_;  ///< locations of the uniforms
    gpu::Buffer vertices_;
    gpu::VertexArray lines_;
    int count_;
};

// The values of uniform variables as text over a picture (RenderOptions::labels).

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
