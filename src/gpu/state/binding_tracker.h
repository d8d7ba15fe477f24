#pragma once
// Binds programs, vertex arrays, textures, samplers, images and buffers, and makes only those GL calls that
// change something.

#include <glad/gl.h>

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/sampler.h"
#include "gpu/object/texture.h"
#include "gpu/object/vertex_array.h"

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

}  // namespace glibra::gpu
