#pragma once
// Compiles shaders as they are written and sets their variables: uniforms by the tags of a Program statement,
// matrices and vertex attributes by glibra's names. This is an independent implementation of language, 5
// and 6. It shares no code with glibra's.

#include <glad/gl.h>

#include <map>
#include <string>
#include <vector>

#include "compatibility_picture.h"
#include "geometry/mesh.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace glibra::oracle {

class CompatibilityProgram {
  public:
    /// Compiles and links. Throws std::runtime_error with the driver's log. The context must be current and
    /// stay current.
    CompatibilityProgram(const GladGLContext& gl, const std::vector<Source>& sources);
    CompatibilityProgram(const CompatibilityProgram&) = delete;
    CompatibilityProgram& operator=(const CompatibilityProgram&) = delete;
    ~CompatibilityProgram();

    void use() const;
    [[nodiscard]] bool hasStage(glsl::Stage stage) const;

    /// Sets every uniform that a tag names, also in uniform blocks.
    void setTags(const std::vector<glib::UniformSpec>& tags);
    /// Sets the uniforms that language, 6 names: uModelViewMatrix and so on, and Timer.
    void setRuntimeValues(const glm::dmat4& modelView, const glm::dmat4& projection, double timer) const;

    /// An active sampler: its location, its texture unit, and the target of its type. The unit is that of the
    /// tag; without a tag that of the declaration, else 0. It is 2 for Noise2 and 3 for Noise3.
    struct Sampler {
        GLint location = 0;
        int unit = 0;
        scene::TextureTarget target = scene::TextureTarget::texture2D;
    };
    [[nodiscard]] std::vector<Sampler> samplers(const std::vector<glib::UniformSpec>& tags) const;

    /// Sets gl_Vertex, gl_Normal, gl_Color, gl_MultiTexCoord0 and the attributes with glibra's names (aVertex
    /// ...) from the mesh, which must outlive the draw. An attribute that the mesh lacks is (0, 0, 0, 1), a
    /// colour is `color`.
    void bindAttributes(const geometry::Mesh& mesh, const glm::dvec4& color) const;
    void unbindAttributes() const;

  private:
    struct Uniform {
        std::string name;  ///< without [0]
        GLenum type = 0;
        GLint size = 1, location = -1, block = -1, offset = -1, arrayStride = 0, matrixStride = 0;
    };
    [[nodiscard]] std::vector<Uniform> uniforms() const;
    [[nodiscard]] bool matches(const std::string& tag, const Uniform& uniform) const;
    void setUniform(const Uniform& uniform, const std::vector<double>& values) const;
    void writeToBlock(const Uniform& uniform, const std::vector<double>& values);

    const GladGLContext& gl_;
    GLuint id_ = 0;
    std::vector<glsl::Stage> stages_;
    std::map<GLint, GLint> declaredUnits_;  ///< layout(binding = n) of samplers, else 0, by location
    std::vector<GLuint> blocks_;            ///< one buffer per uniform block
};

}  // namespace glibra::oracle
