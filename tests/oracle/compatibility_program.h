#pragma once
// Shaders compiled as they are written, and what their names are given: uniforms by the tags of a Program
// statement, matrices and vertex attributes by glibra's names. Written against the language specification
// (sections 5 and 6), not against glibra's own code for the same job.

#include <glad/gl.h>

#include <map>
#include <string>
#include <vector>

#include "compatibility_picture.h"
#include "geometry/mesh.h"
#include "scene/matrices.h"
#include "scene/scene.h"

namespace glibra::oracle {

class CompatibilityProgram {
  public:
    /// Compiles and links; throws std::runtime_error with the driver's log. The context must be current and
    /// stay so.
    CompatibilityProgram(const GladGLContext& gl, const std::vector<Source>& sources);
    CompatibilityProgram(const CompatibilityProgram&) = delete;
    CompatibilityProgram& operator=(const CompatibilityProgram&) = delete;
    ~CompatibilityProgram();

    void use() const;
    [[nodiscard]] bool hasStage(glsl::Stage stage) const;

    /// Sets every uniform that a tag names, in the default block and in uniform blocks.
    void setTags(const std::vector<glib::UniformSpec>& tags);
    /// Sets the uniforms named in the specification's section 6: uModelViewMatrix and so on, and Timer.
    void setRuntimeValues(const scene::DrawMatrices& matrices, double timer) const;

    /// An active sampler: its location, the unit that its tag names (without one that of its declaration,
    /// else 0; 2 for Noise2, 3 for Noise3), and the target its type asks for.
    struct Sampler {
        GLint location = 0;
        int unit = 0;
        scene::TextureTarget target = scene::TextureTarget::texture2D;
    };
    [[nodiscard]] std::vector<Sampler> samplers(const std::vector<glib::UniformSpec>& tags) const;

    /// Feeds gl_Vertex, gl_Normal, gl_Color and gl_MultiTexCoord0 and the attributes of glibra's names
    /// (aVertex ...) from the mesh, which must outlive the draw. What the mesh has not is (0, 0, 0, 1), a
    /// colour `color`.
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
    std::map<GLint, GLint> declaredUnits_;  ///< of samplers, by location: layout(binding = n), else 0
    std::vector<GLuint> blocks_;            ///< a buffer for each uniform block
};

}  // namespace glibra::oracle
