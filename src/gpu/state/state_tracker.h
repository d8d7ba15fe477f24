#pragma once
// Binds programs, vertex arrays, textures, samplers, images and buffers, and makes only those GL calls that
// change something.

#include <glad/gl.h>

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "base/raster_state.h"
#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/readback.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

/// Keeps what it has bound. Whoever binds such objects by other calls, or deletes one that is bound, calls
/// one of the forget functions afterwards.
class BindingTracker {
  public:
    /// Nothing is known about the context's bindings. The lists keep their memory, since every frame begins
    /// so.
    void forget();
    /// Work on textures, such as making one, leaves its own texture on unit 0.
    void forgetWorkUnit();
    void forgetBuffers() { buffers_.clear(); }
    /// Forgets what is bound to image units.
    void forgetImages() { images_.clear(); }

    void use(const Program& program);
    void bind(const VertexArray& array);
    /// Texture::bind.
    void bind(const Texture& texture, int unit);
    void bind(const Sampler& sampler, int unit);
    /// Texture::bindImage.
    void bindImage(const Texture& texture, int unit, int level, std::optional<int> layer, GLenum access,
                   std::optional<TexelFormat> as = {});
    /// Buffer::bindBase.
    void bindBase(const Buffer& buffer, GLenum target, GLuint index);

  private:
    // Names of GL objects; 0 where nothing is known.
    struct Unit {
        std::array<GLuint, kTextureShapes> textures{};  ///< by TextureShape
        GLuint sampler = 0;
    };
    struct IndexedBuffer {
        GLenum target = 0;
        GLuint index = 0, name = 0;
    };
    using Image = std::tuple<GLuint, int, std::optional<int>, GLenum, std::optional<TexelFormat>>;
    Unit& unit(int index);

    GLuint program_ = 0, array_ = 0;
    std::vector<Unit> units_;
    std::vector<std::optional<Image>> images_;  ///< by unit
    std::vector<IndexedBuffer> buffers_;        ///< few, so that a search is fast
};

// Sets the fixed-function state of the context, and makes only those GL calls that change something.

/// The rectangle in pixels of a target. Each edge is rounded to the nearest pixel edge, so that rectangles
/// that share an edge neither overlap nor leave a gap.
PixelRectangle pixelsOf(const base::FractionRectangle& rectangle, int width, int height);

/// Keeps what it has set. Whoever changes such state by other calls calls forget() afterwards.
class RasterTracker {
  public:
    explicit RasterTracker(const Capabilities& capabilities) : capabilities_(&capabilities) {}

    /// Nothing is known about the context's state: the next apply() sets all of it.
    void forget();
    /// The target with that size has been bound, and its viewport has been set to the whole of it.
    void targetBound(int width, int height);
    /// Draws and clears change only these pixels, until it is called again without them.
    void limitTo(const std::optional<PixelRectangle>& pixels) { limit_ = pixels; }

    /// Sets the state for draws into the bound target, mirrored as its depth order says. Line widths and
    /// point sizes are limited to those of the driver.
    void apply(const base::RasterState& state);
    /// The pixels that draws with the applied state can change.
    [[nodiscard]] PixelRectangle drawnPixels() const;
    /// Draws change only those of drawnPixels() that lie in the rectangle, which may be empty, until the next
    /// call, or apply().
    void narrowTo(const PixelRectangle& pixels);
    /// Opens all write masks and sets the scissor to the limit alone, so that clears change all pixels.
    void openForClears();

  private:
    template <class T, class Set>
    void change(std::optional<T>& known, const T& wanted, Set&& set) {
        if (known && *known == wanted) return;
        set();
        known = wanted;
    }
    void enable(std::optional<bool>& known, GLenum capability, bool on);
    void applyFaces(const base::RasterState& state);
    void applyDepth(const base::RasterState& state);
    void applyStencil(const base::RasterState& state);
    void applyStencilFace(GLenum face, std::optional<base::StencilFace>& known,
                          const base::StencilFace& wanted);
    void applyBlending(const base::RasterState& state);
    void applyWriteMasks(const std::array<base::ColorMask, base::kRasterTargets>& masks);
    void applySamples(const base::RasterState& state);
    void applyRectangles(const base::RasterState& state);
    void applyScissor(const std::optional<PixelRectangle>& pixels);
    void applySizes(const base::RasterState& state);

    /// What has been set; nothing where it is not known.
    struct Known {
        std::optional<bool> cullOn, discard, offsetOn, depthTest, depthWrite, depthClamp, stencilTest,
            multisample, alphaToCoverage, sampleShadingOn, scissorOn, programPointSize;
        std::optional<GLenum> cullFace, frontFace, polygonMode, provoking, depthFunction;
        std::optional<std::array<float, 2>> offset;
        std::optional<std::array<double, 2>> depthRange;
        std::optional<base::StencilFace> stencilFront, stencilBack;
        std::optional<std::array<bool, base::kRasterTargets>> blendOn;
        std::array<std::optional<std::array<base::BlendFunction, 2>>, base::kRasterTargets> blend;
        std::optional<std::array<float, 4>> blendConstant;
        std::optional<std::array<base::ColorMask, base::kRasterTargets>> write;
        std::optional<float> sampleShading, lineWidth, pointSize;
        std::optional<std::array<int, 4>> viewport, scissor;
    };

    const Capabilities* capabilities_;
    bool clipsFromZero_ = false;  ///< glClipControl, which nobody else calls: forget() keeps it
    Known known_;
    std::optional<PixelRectangle> limit_;
    std::optional<PixelRectangle> drawn_;  ///< the scissor of the applied state
    int width_ = 1, height_ = 1;           ///< of the bound target
};

}  // namespace glibra::gpu
