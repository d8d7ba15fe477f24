#pragma once
// The textures of a scene in the compatibility context. Each is made at its first use.

#include <glad/gl.h>

#include <map>
#include <vector>

#include "compatibility_context.h"
#include "scene/scene.h"

namespace glibra::oracle {

class CompatibilityTextures {
  public:
    /// The context must be current and stay current.
    CompatibilityTextures(const GladGLContext& gl, const scene::Scene& scene) : gl_(gl), scene_(scene) {}
    CompatibilityTextures(const CompatibilityTextures&) = delete;
    CompatibilityTextures& operator=(const CompatibilityTextures&) = delete;
    ~CompatibilityTextures();

    /// The GL name of Scene::textures[index]. Throws std::runtime_error if its file cannot be read.
    GLuint texture(scene::TextureIndex index);
    /// Binds it to a texture image unit, with the sampling rules of language, 2.4.
    void bind(scene::TextureIndex index, GLuint unit, bool clamp);

  private:
    [[nodiscard]] GLenum targetOf(scene::TextureIndex index) const;
    void fill(scene::TextureIndex index) const;
    const GladGLContext& gl_;
    const scene::Scene& scene_;
    std::map<scene::TextureIndex, GLuint> names_;
};

}  // namespace glibra::oracle
