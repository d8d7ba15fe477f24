#pragma once
// --axes: three axes two units long with the letters X, Y and Z at their ends.

#include <glibra/result.h>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/vertex_array.h"
#include "render/draw/frame.h"
#include "scene/scene.h"

namespace glibra::render {

class Axes {
  public:
    static Result<Axes> create(const gpu::Context& context);

    /// Draws into the bound target, which shows `tile` of a picture of that size, with the projection of the
    /// scene's last draw into the window and the world's view.
    void draw(const scene::Scene& scene, const ViewMatrices& view, const Tile& tile, int width,
              int height) const;

  private:
    Axes(gpu::Program program, base::ActiveUniform matrix, gpu::Buffer vertices, gpu::VertexArray lines,
         int count);

    gpu::Program program_;
    base::ActiveUniform matrix_;
    gpu::Buffer vertices_;
    gpu::VertexArray lines_;
    int count_;
};

}  // namespace glibra::render
