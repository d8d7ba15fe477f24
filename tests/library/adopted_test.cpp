// Scenes in a context of the calling program, which sets what it likes between two calls.

#include <glad/gl.h>
#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glibra {
namespace {

using Bytes = std::vector<std::byte>;

/// A scene of two squares, one behind the other. They show a texture of 3 x 3 texels.
constexpr const char* kCovered =
    "WindowSize 33 17\nBackground .1 .2 .3\nTexture2D photo photo.tex\nVertex covered.vert\n"
    "Fragment covered.frag\nProgram Covered\nQuadXY -.5 .6\nQuadXY .5 .9\n";

std::map<std::string, std::string> filesOfCovered() {
    const std::array<std::int32_t, 2> size{3, 3};
    std::string texels(sizeof size, '\0');
    std::memcpy(texels.data(), size.data(), sizeof size);
    for (int i = 0; i < 36; ++i) texels += static_cast<char>(i % 4 == 3 ? 255 : 40 + 37 * i % 200);
    return {{"photo.tex", texels},
            {"covered.vert",
             "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xyz, 1); }\n"},
            {"covered.frag",
             "#version 330\nuniform sampler2D photo;\nout vec4 color;\n"
             "void main() { color = vec4(texture(photo, gl_FragCoord.xy / vec2(33, 17)).rgb, .7); }\n"}};
}

/// A renderer in the context of another one, which stands for the calling program.
struct Adopted {
    Renderer owner;
    Renderer guest;
};

Adopted adoptedRenderer() {
    Result<Renderer> owner = Renderer::open();
    EXPECT_TRUE(owner) << owner.message();
    Result<Renderer> guest = Renderer::open(Renderer::current());
    EXPECT_TRUE(guest) << guest.message();
    return {std::move(*owner), std::move(*guest)};
}

Scene coveredScene(Renderer& renderer) {
    Result<Scene> scene = renderer.loadText(kCovered, "covered.glib", filesOfCovered());
    EXPECT_TRUE(scene) << scene.message();
    return std::move(*scene);
}

/// The pictures with and without multisampling, the window as floats, and a texture. `before` runs before
/// each call, as the calling program does.
std::vector<Bytes> everythingOf(Scene& scene, void (*before)()) {
    std::vector<Bytes> all;
    const auto add = [&](Result<Picture> picture) {
        EXPECT_TRUE(picture) << picture.message();
        all.push_back(picture ? picture->data : Bytes());
    };
    before();
    add(scene.draw({.samples = 4}));
    before();
    add(scene.draw());
    before();
    add(scene.target("window"));
    before();
    add(scene.target("photo"));
    return all;
}

/// State that a program may set.
struct ForeignState {
    const char* name;
    void (*set)();
    int since = 41;  ///< the version of OpenGL that has it
};

void storePixels(const std::vector<GLenum>& names, GLint value) {
    for (const GLenum each : names) glPixelStorei(each, value);
}

/// A buffer that holds more than any picture here, bound to a target. It lives as long as the context.
void bindLargeBuffer(GLenum target) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, 1 << 20, nullptr, GL_STREAM_READ);
}

void bindMipmapSamplers() {
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (GLuint unit = 0; unit < 16; ++unit) glBindSampler(unit, sampler);
}

void beginConditionalRendering() {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glEndQuery(GL_SAMPLES_PASSED);
    glBeginConditionalRender(query, GL_QUERY_WAIT);
}

constexpr ForeignState kForeignStates[] = {
    {"nothing", [] {}},
    // How pixels lie in memory.
    {"pack row length", [] { storePixels({GL_PACK_ROW_LENGTH}, 400); }},
    {"pack skips", [] { storePixels({GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES}, 5); }},
    {"pack alignment", [] { storePixels({GL_PACK_ALIGNMENT}, 8); }},
    {"pack image height", [] { storePixels({GL_PACK_IMAGE_HEIGHT}, 300); }},
    {"pack swap", [] { storePixels({GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST}, GL_TRUE); }},
    {"pack buffer", [] { bindLargeBuffer(GL_PIXEL_PACK_BUFFER); }},
    {"unpack row length", [] { storePixels({GL_UNPACK_ROW_LENGTH}, 400); }},
    {"unpack skips",
     [] { storePixels({GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES}, 5); }},
    {"unpack alignment", [] { storePixels({GL_UNPACK_ALIGNMENT}, 8); }},
    {"unpack image height", [] { storePixels({GL_UNPACK_IMAGE_HEIGHT}, 300); }},
    {"unpack swap", [] { storePixels({GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST}, GL_TRUE); }},
    {"unpack buffer", [] { bindLargeBuffer(GL_PIXEL_UNPACK_BUFFER); }},
    {"clamped reads", [] { glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE); }},
    // What primitives are made of, and where they are cut.
    {"primitive restart",
     [] {
         glEnable(GL_PRIMITIVE_RESTART);
         glPrimitiveRestartIndex(0);
     }},
    {"primitive restart, fixed index", [] { glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX); }, 43},
    {"clip distances",
     [] {
         for (GLenum i = 0; i < 8; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
     }},
    {"clip control", [] { glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE); }, 45},
    {"depth clamp", [] { glEnable(GL_DEPTH_CLAMP); }},
    {"depth range", [] { glDepthRange(1, 0); }},
    {"viewport arrays",
     [] {
         glViewportIndexedf(0, 0, 0, 2, 2);
         glScissorIndexed(0, 0, 0, 1, 1);
         glEnablei(GL_SCISSOR_TEST, 0);
     }},
    {"patches",
     [] {
         constexpr std::array<GLfloat, 4> kLevels{7, 7, 7, 7};
         glPatchParameteri(GL_PATCH_VERTICES, 5);
         glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, kLevels.data());
         glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, kLevels.data());
     }},
    {"provoking vertex", [] { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); }},
    // Rasterization.
    {"rasterizer discard", [] { glEnable(GL_RASTERIZER_DISCARD); }},
    {"polygon mode", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); }},
    {"polygon offset",
     [] {
         glEnable(GL_POLYGON_OFFSET_FILL);
         glPolygonOffset(-10000, -100000);
     }},
    {"smooth",
     [] {
         glEnable(GL_LINE_SMOOTH);
         glEnable(GL_POLYGON_SMOOTH);
     }},
    {"culling",
     [] {
         glEnable(GL_CULL_FACE);
         glCullFace(GL_FRONT_AND_BACK);
         glFrontFace(GL_CW);
     }},
    {"points",
     [] {
         glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 60);
         glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
         glEnable(GL_PROGRAM_POINT_SIZE);
     }},
    {"no multisampling", [] { glDisable(GL_MULTISAMPLE); }},
    {"sample mask",
     [] {
         glEnable(GL_SAMPLE_MASK);
         glSampleMaski(0, 1);
     }},
    {"sample coverage",
     [] {
         glEnable(GL_SAMPLE_COVERAGE);
         glSampleCoverage(.25F, GL_TRUE);
     }},
    {"alpha to one", [] { glEnable(GL_SAMPLE_ALPHA_TO_ONE); }},
    {"alpha to coverage", [] { glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE); }},
    {"sample shading",
     [] {
         glEnable(GL_SAMPLE_SHADING);
         glMinSampleShading(1);
     }},
    // Fragments.
    {"scissor",
     [] {
         glEnable(GL_SCISSOR_TEST);
         glScissor(0, 0, 5, 5);
     }},
    {"stencil",
     [] {
         glEnable(GL_STENCIL_TEST);
         glStencilFunc(GL_NEVER, 0, 0);
         glStencilMask(0);
     }},
    {"no depth test", [] { glDisable(GL_DEPTH_TEST); }},
    {"depth function", [] { glDepthFunc(GL_GREATER); }},
    {"no depth writes", [] { glDepthMask(GL_FALSE); }},
    {"blending",
     [] {
         glEnablei(GL_BLEND, 0);
         glBlendFunc(GL_ONE, GL_ONE);
         glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
     }},
    {"logic op",
     [] {
         glEnable(GL_COLOR_LOGIC_OP);
         glLogicOp(GL_INVERT);
     }},
    {"sRGB", [] { glEnable(GL_FRAMEBUFFER_SRGB); }},
    {"dithering", [] { glEnable(GL_DITHER); }},
    {"color mask", [] { glColorMaski(0, GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE); }},
    {"clear values",
     [] {
         glClearColor(1, 0, 1, 1);
         glClearDepth(.2);
         glClearStencil(3);
     }},
    // Bindings, and what has begun.
    {"samplers", bindMipmapSamplers},
    {"no seamless cube maps", [] { glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS); }},
    {"query buffer", [] { bindLargeBuffer(GL_QUERY_BUFFER); }, 44},
    {"program pipeline",
     [] {
         GLuint pipeline = 0;
         glGenProgramPipelines(1, &pipeline);
         glUseProgram(0);
         glBindProgramPipeline(pipeline);
     }},
    {"window's framebuffer", [] { glBindFramebuffer(GL_FRAMEBUFFER, 0); }},
    {"conditional rendering", beginConditionalRendering},
    {"hints", [] { glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_FASTEST); }},
    {"no debug output", [] { glDisable(GL_DEBUG_OUTPUT); }, 43},
    {"an error", [] { glEnable(GL_TEXTURE0); }},
};

TEST(AdoptedContext, DrawsTheSameWhateverTheProgramSets) {
    Adopted renderers = adoptedRenderer();
    Scene own = coveredScene(renderers.owner);
    const std::vector<Bytes> expected = everythingOf(own, [] {});
    Scene scene = coveredScene(renderers.guest);
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    for (const ForeignState& each : kForeignStates) {
        if (10 * major + minor < each.since) continue;
        EXPECT_EQ(everythingOf(scene, each.set), expected) << each.name;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << each.name;
        each.set();
        Scene loaded = coveredScene(renderers.guest);
        EXPECT_EQ(everythingOf(loaded, [] {}), expected) << each.name << ", before loading";
    }
}

TEST(AdoptedContext, PausesTransformFeedback) {
    Adopted renderers = adoptedRenderer();
    Scene scene = coveredScene(renderers.guest);
    const std::vector<Bytes> expected = everythingOf(scene, [] {});
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    const char* const text = "#version 410 core\nvoid main() { gl_Position = vec4(0); }\n";
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader);
    const char* const captured = "gl_Position";
    glTransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    GLuint feedback = 0, buffer = 0;
    glGenTransformFeedbacks(1, &feedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 16, nullptr, GL_STREAM_READ);
    glUseProgram(program);
    glBeginTransformFeedback(GL_POINTS);
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(everythingOf(scene, [] {}), expected);
    // The program goes on where it was.
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    glUseProgram(program);
    glResumeTransformFeedback();
    glEndTransformFeedback();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glDeleteTransformFeedbacks(1, &feedback);
    glDeleteBuffers(1, &buffer);
    glDeleteProgram(program);
    glDeleteShader(shader);
}

TEST(AdoptedContext, HasToBeCurrent) {
    Adopted renderers = adoptedRenderer();
    Scene scene = coveredScene(renderers.guest);
    const std::vector<Bytes> expected = everythingOf(scene, [] {});
    {
        const Result<Renderer> other = Renderer::open();  // whose context is current now
        ASSERT_TRUE(other) << other.message();
        for (const Result<Picture>& each : {scene.draw(), scene.target("photo")}) {
            ASSERT_FALSE(each);
            EXPECT_EQ(each.diagnostics().front().id, "gpu-E01");
            EXPECT_NE(each.message().find("not current"), std::string::npos) << each.message();
        }
        EXPECT_FALSE(renderers.guest.loadText(kCovered, "covered.glib", filesOfCovered()));
    }
    EXPECT_FALSE(scene.draw());  // no context is current
    static_cast<void>(coveredScene(renderers.owner));
    EXPECT_EQ(everythingOf(scene, [] {}), expected);
}

TEST(AdoptedContext, MayEndWhileAnotherOneIsCurrent) {
    Result<Renderer> other;
    {
        Adopted renderers = adoptedRenderer();
        Scene scene = coveredScene(renderers.guest);
        EXPECT_TRUE(scene.draw());
        other = Renderer::open();
        ASSERT_TRUE(other) << other.message();
    }
    Scene scene = coveredScene(*other);
    EXPECT_TRUE(scene.draw());
}

}  // namespace
}  // namespace glibra
