#pragma once
// --axes: three axes with the letters X, Y and Z at their ends, as glman draws them: kAxisLength units long,
// white and thick.

#include <glibra/result.h>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/vertex_array.h"
#include "render/draw/tile.h"
#include "render/draw/view_matrices.h"
#include "scene/scene.h"

namespace glibra::render {

inline constexpr double kAxisLength = 1.5;       ///< units of world space
inline constexpr double kAxisWidth = 1.0 / 200;  ///< of the lines, as a part of the picture's height
inline constexpr double kLeastAxisWidth = 1.5;   ///< pixels

class Axes {
  public:
    static Result<Axes> create(const gpu::Context& context);

    /// Draws into the target, which shows `tile` of a picture of that size, with the projection of the
    /// scene's last draw into the window and the world's view. Whatever is nearer hides the axes.
    void draw(const gpu::Target& target, const scene::Scene& scene, const ViewMatrices& view,
              const Tile& tile, int width, int height) const;

  private:
    Axes(gpu::Program program, gpu::Buffer vertices, gpu::VertexArray lines, int count);

    gpu::Program program_;
    GLint matrix_, part_, half_;  ///< locations of the uniforms
    gpu::Buffer vertices_;
    gpu::VertexArray lines_;
    int count_;
};

}  // namespace glibra::render
