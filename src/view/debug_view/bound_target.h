#pragma once
// What hooks of a FrameDrawer do with the framebuffer that is bound for drawing: read it, and draw beside it.

#include <glad/gl.h>

#include <array>
#include <optional>
#include <string>

#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "render/check/object_content.h"
#include "render/live/live_scene.h"
#include "view/debug_view/frame_items.h"

namespace glibra::view {

/// The state of the context that hooks change; the destructor restores it.
class KeptState {
  public:
    KeptState();
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;
    ~KeptState();

  private:
    static constexpr std::size_t kOutputs = 8;
    struct Output {
        GLboolean blends = GL_FALSE;
        std::array<GLboolean, 4> mask{};
    };
    std::array<GLboolean, 5> switches_{};  ///< depth, stencil and scissor test, culling, sRGB
    std::array<Output, kOutputs> outputs_{};
    std::array<GLint, 4> scissor_{};
    GLint draw_ = 0, read_ = 0, program_ = 0, vertices_ = 0, renderbuffer_ = 0;
    GLboolean depthMask_ = GL_TRUE;
    GLint depthFunction_ = 0, stencilFront_ = 0, stencilBack_ = 0;
};

/// One of the layers or faces that a pass draws into at once.
struct LayerOfPass {
    gpu::TextureShape shape = gpu::TextureShape::array2D;  ///< of what the pass draws into
    int layer = 0;
};

/// Binds one layer of the framebuffer that is bound for drawing in its place, with all its attachments.
/// The destructor binds the whole one again.
class BoundLayer {
  public:
    /// Without a layer it does nothing.
    explicit BoundLayer(const std::optional<LayerOfPass>& layer);
    BoundLayer(const BoundLayer&) = delete;
    BoundLayer& operator=(const BoundLayer&) = delete;
    ~BoundLayer();

  private:
    GLuint whole_ = 0, layer_ = 0;
};

/// A part of the framebuffer that is bound for drawing.
struct BoundPart {
    FrameTarget::Kind kind = FrameTarget::Kind::color;  ///< color, depth or stencil
    int output = 0;
    std::optional<base::TexelFormat> format{};  ///< if it is known
    int width = 1, height = 1;                  ///< of the framebuffer
    std::optional<LayerOfPass> layer{};         ///< if it has several
};

/// The numbers of that part. `mostSide`: larger pictures are made smaller, to that many texels; 0: none is.
/// `only`: one rectangle of it. Nothing if the driver cannot read it.
std::optional<render::Content> readBound(const gpu::Capabilities& capabilities, const BoundPart& part,
                                         int mostSide, const std::optional<gpu::PixelRectangle>& only = {});
/// The same for layer 0, or that of the view, of a level of a texture.
std::optional<render::Content> readTexture(const gpu::Capabilities& capabilities, const gpu::Texture& texture,
                                           const scene::TextureView& view, int mostSide);

/// Size of what a pass draws into; `width` and `height` are those of the window.
gpu::TextureSize sizeOf(const render::LiveScene& scene, const scene::Pass& pass, int width, int height);
/// How many layers or faces the pass draws into at once, between which gl_Layer chooses; 1: one.
int layersOf(const render::LiveScene& scene, const scene::Pass& pass);
/// That layer, or the last one if there are fewer; nothing: the pass draws into one only.
std::optional<LayerOfPass> layerOf(const render::LiveScene& scene, const scene::Pass& pass, int layer);
/// The part of the framebuffer of a pass that the target is.
BoundPart partOf(const render::LiveScene& scene, const FrameTarget& target, const gpu::TextureSize& size,
                 const std::optional<LayerOfPass>& layer = {});
/// "layer 2", or "face -y" of a cube, or "cube 1, face -y".
std::string layerName(const render::LiveScene& scene, const scene::Pass& pass, int layer);

/// A colour of floats beside the depth of the bound framebuffer: what is drawn into it is tested as in that.
class BesideTarget {
  public:
    /// Call it while the framebuffer of the pass is bound for drawing. Nothing if the driver cannot draw into
    /// such a combination. `layer`: that read() reads where the pass draws into several at once.
    static std::optional<BesideTarget> make(const gpu::Capabilities& capabilities,
                                            const render::LiveScene& scene, const scene::Pass& pass,
                                            const gpu::TextureSize& size, int layer = 0);
    /// Binds it for drawing; colour output `output` is written.
    void bind(int output) const;
    /// Sets the colour to zero.
    void clear() const;
    /// Red, green, blue, alpha, bottom row first; of one rectangle, or of all.
    [[nodiscard]] render::Content read(const gpu::Capabilities& capabilities,
                                       const std::optional<gpu::PixelRectangle>& only = {}) const;

  private:
    gpu::Renderbuffer color_;
    std::optional<gpu::Texture> layers_;  ///< in place of color_, for a pass into several layers
    std::optional<gpu::Framebuffer> framebuffer_;
    std::optional<gpu::Framebuffer> layer_;  ///< the layer that is read
    int width_ = 1, height_ = 1;
};

}  // namespace glibra::view
