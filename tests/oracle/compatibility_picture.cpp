#include "compatibility_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "compatibility_program.h"
#include "compatibility_textures.h"
#include "scene/primitives.h"
#include "scene/view.h"

namespace glibra::oracle {
namespace {

/// A framebuffer with its own depth buffer, and with any number of colour textures or, for the window, a
/// renderbuffer.
class Target {
  public:
    Target(const GladGLContext& gl, int width, int height, const std::vector<GLuint>& textures) : gl_(gl) {
        gl.GenFramebuffers(1, &framebuffer_);
        gl.GenRenderbuffers(1, &color_);
        gl.GenRenderbuffers(1, &depth_);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl.BindRenderbuffer(GL_RENDERBUFFER, depth_);
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
        if (textures.empty()) {
            gl.BindRenderbuffer(GL_RENDERBUFFER, color_);
            gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
            gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
        }
        std::vector<GLenum> buffers{GL_COLOR_ATTACHMENT0};
        for (GLuint i = 0; i < textures.size(); ++i) {
            if (i > 0) buffers.push_back(GL_COLOR_ATTACHMENT0 + i);
            gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, textures[i], 0);
        }
        gl.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the oracle's framebuffer is not complete");
        gl.Viewport(0, 0, width, height);
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target() {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(1, &color_);
        gl_.DeleteRenderbuffers(1, &depth_);
    }
    void bind() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

  private:
    const GladGLContext& gl_;
    GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

GLenum glMode(geometry::Topology topology) {
    switch (topology) {
        case geometry::Topology::points:
            return GL_POINTS;
        case geometry::Topology::lines:
            return GL_LINES;
        case geometry::Topology::linesAdjacency:
            return GL_LINES_ADJACENCY;
        case geometry::Topology::triangles:
            return GL_TRIANGLES;
        case geometry::Topology::trianglesAdjacency:
            return GL_TRIANGLES_ADJACENCY;
        case geometry::Topology::patches:
            break;
    }
    return GL_PATCHES;
}

/// Draws one scene.
class Drawing {
  public:
    Drawing(const GladGLContext& gl, const scene::Scene& scene,
            const std::vector<std::vector<Source>>& sources, const WrittenOutputs& written)
        : gl_(gl), scene_(scene), textures_(gl, scene), written_(written) {
        for (const std::vector<Source>& each : sources)
            programs_.push_back(std::make_unique<CompatibilityProgram>(gl, each));
    }

    Pixels draw() {
        setFixedState();
        for (const scene::Pass& pass : scene_.frame.passes) drawPass(pass);
        Pixels pixels{scene_.width, scene_.height, {}};
        const auto row = static_cast<std::size_t>(scene_.width) * 4;
        pixels.data.resize(row * static_cast<std::size_t>(scene_.height));
        window().bind();
        for (int y = 0; y < scene_.height; ++y)  // GL's first row is the bottom row
            gl_.ReadPixels(0, scene_.height - 1 - y, scene_.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                           pixels.data.data() + static_cast<std::size_t>(y) * row);
        if (const GLenum code = gl_.GetError(); code != GL_NO_ERROR)
            throw std::runtime_error("GL error in the oracle's context: " + std::to_string(code));
        return pixels;
    }

  private:
    /// Sets the fixed state of a draw (language, 2.2).
    void setFixedState() const {
        gl_.Enable(GL_DEPTH_TEST);
        gl_.DepthFunc(GL_LEQUAL);
        gl_.Disable(GL_DITHER);
        gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        // Mesa computes gl_LightSource[i].halfVector only when a position changes.
        gl_.MatrixMode(GL_MODELVIEW);
        gl_.LoadIdentity();
        for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
            for (const auto& position :
                 {std::array<GLfloat, 4>{0, 1, 0, 0}, std::array<GLfloat, 4>{0, 0, 1, 0}})
                gl_.Lightfv(light, GL_POSITION, position.data());
        gl_.Enable(GL_POINT_SPRITE);  // without it gl_PointCoord has no value in this profile
        if (written_.backColors)
            gl_.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
        else
            gl_.Disable(GL_VERTEX_PROGRAM_TWO_SIDE);
        for (int i = 0; i < 8; ++i) {
            const GLenum distance = GL_CLIP_DISTANCE0 + static_cast<GLenum>(i);
            i < written_.clipDistances ? gl_.Enable(distance) : gl_.Disable(distance);
        }
    }

    const Target& window() {
        if (!window_) window_.emplace(gl_, scene_.width, scene_.height, std::vector<GLuint>{});
        return *window_;
    }

    void drawPass(const scene::Pass& pass) {
        const bool isWindow = pass.targets.empty();
        std::optional<Target> offscreen;
        int width = scene_.width;
        int height = scene_.height;
        if (!isWindow) {
            std::vector<GLuint> names;
            for (const scene::TextureIndex each : pass.targets) names.push_back(textures_.texture(each));
            const auto& size = std::get<scene::EmptySource>(scene_.textures[pass.targets.front()].source);
            width = size.width;
            height = size.height;
            offscreen.emplace(gl_, width, height, names);
        }
        (isWindow ? window() : *offscreen).bind();
        gl_.Viewport(0, 0, width, height);
        for (std::size_t i = 0; i < pass.clearColors.size(); ++i)
            if (pass.clearColors[i]) {
                const glm::vec4 color(*pass.clearColors[i]);
                gl_.ClearBufferfv(GL_COLOR, static_cast<GLint>(i), glm::value_ptr(color));
            }
        if (pass.clearDepth) gl_.Clear(GL_DEPTH_BUFFER_BIT);
        isWindow ? gl_.Enable(GL_BLEND) : gl_.Disable(GL_BLEND);
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<scene::Draw>(&step);
            if (!draw) throw std::runtime_error("the oracle does not support Clear");
            drawOne(*draw, static_cast<double>(width) / height);
        }
    }

    void drawOne(const scene::Draw& draw, double aspect) {
        const std::vector<glib::UniformSpec>& tags = scene_.programs[draw.program].uniforms;
        const glm::dmat4 projection = scene::projectionMatrix(*draw.projection, aspect);
        gl_.MatrixMode(GL_PROJECTION);
        gl_.LoadMatrixd(glm::value_ptr(projection));
        gl_.MatrixMode(GL_MODELVIEW);
        gl_.LoadMatrixd(glm::value_ptr(draw.modelView));

        CompatibilityProgram& program = *programs_[draw.program];
        program.use();
        program.setTags(tags);
        program.setRuntimeValues(draw.modelView, projection, 0);
        bindTextures(program, draw, tags);

        gl_.ShadeModel(draw.flatColors ? GL_FLAT : GL_SMOOTH);
        gl_.PointSize(static_cast<GLfloat>(draw.raster->pointSize));
        gl_.LineWidth(static_cast<GLfloat>(draw.raster->lineWidth));
        draw.raster->pointSizeFromShader ? gl_.Enable(GL_PROGRAM_POINT_SIZE)
                                         : gl_.Disable(GL_PROGRAM_POINT_SIZE);
        const auto [known, isNew] = meshes_.try_emplace(draw.shape);
        if (isNew) {
            Result<geometry::Mesh> made = scene::makeMesh(scene_, draw.shape);
            if (!made) throw std::runtime_error("the oracle cannot make the mesh");
            known->second = std::move(*made);
        }
        const geometry::Mesh& mesh = known->second;
        program.bindAttributes(mesh, draw.color);
        GLenum mode = glMode(mesh.topology);
        if (program.hasStage(glsl::Stage::tessEvaluation)) {
            mode = GL_PATCHES;
            gl_.PatchParameteri(GL_PATCH_VERTICES,
                                mesh.patchVertices ? mesh.patchVertices : draw.patchVertices);
        }
        gl_.DrawElements(mode, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT,
                         mesh.indices.data());
        program.unbindAttributes();
    }

    void bindTextures(const CompatibilityProgram& program, const scene::Draw& draw,
                      const std::vector<glib::UniformSpec>& tags) {
        GLuint unit = 0;
        for (const CompatibilityProgram::Sampler& sampler : program.samplers(tags)) {
            for (const scene::Slot& slot : scene_.slotTables[draw.slots])
                if (slot.unit == sampler.unit && slot.target == sampler.target)
                    textures_.bind(slot.texture, unit, draw.sampling.clamp);
            gl_.Uniform1i(sampler.location, static_cast<GLint>(unit));
            ++unit;
        }
    }

    const GladGLContext& gl_;
    const scene::Scene& scene_;
    CompatibilityTextures textures_;
    scene::List<std::unique_ptr<CompatibilityProgram>, scene::Program> programs_;
    WrittenOutputs written_;
    std::optional<Target> window_;
    std::map<scene::ShapeIndex, geometry::Mesh> meshes_;
};

}  // namespace

Pixels drawAsWritten(const CompatibilityContext& context, const scene::Scene& scene,
                     const std::vector<std::vector<Source>>& sources, const WrittenOutputs& written) {
    const CompatibilityContext::Current current(context);
    return Drawing(context.gl(), scene, sources, written).draw();
}

}  // namespace glibra::oracle
