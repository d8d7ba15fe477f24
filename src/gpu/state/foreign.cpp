#include "gpu/state/foreign.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "gpu/context/errors.h"
#include "gpu/object/name.h"
#include "gpu/state/state_tracker.h"

namespace glibra::gpu {
namespace {

Diagnostic refused(std::string text) {
    return diagnose("library-E08", std::move(text));
}

/// Why the framebuffer that is bound for drawing takes no picture.
std::optional<Diagnostic> problemOfBound(const std::string& name) {
    if (const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
        status != GL_FRAMEBUFFER_COMPLETE)
        return refused(status == GL_FRAMEBUFFER_UNDEFINED
                           ? fmt::format("{} does not exist: the current context has no window", name)
                           : fmt::format("{} is not complete (0x{:x})", name, status));
    GLint outputs = 0;
    bool hasColor = false;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &outputs);
    for (int i = 0; i < outputs; ++i) {
        GLint buffer = GL_NONE, kind = GL_NONE, type = GL_NONE;
        glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
        if (buffer == GL_NONE) continue;
        hasColor = true;
        // A window's own has no integers, and its colours have other names.
        if (buffer < GL_COLOR_ATTACHMENT0 || buffer > GL_COLOR_ATTACHMENT31) continue;
        const auto point = static_cast<GLenum>(buffer);
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        if (kind == GL_NONE) continue;
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
        if (type == GL_INT || type == GL_UNSIGNED_INT)
            return refused(fmt::format("{} holds integers, and a picture has none", name));
    }
    if (hasColor) return {};
    return refused(fmt::format("{} has no colour that is drawn into (glDrawBuffers)", name));
}

void makeOpaque(const PixelRectangle& part) {
    GLint outputs = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &outputs);
    constexpr std::array<GLfloat, 4> kOnes{1, 1, 1, 1};
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    for (int i = 0; i < outputs; ++i) {
        GLint buffer = GL_NONE;
        glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
        if (buffer != GL_NONE) glClearBufferfv(GL_COLOR, i, kOnes.data());
    }
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

Result<TextureSize> sizeOfForeign(GLuint texture) {
    GLint width = 0, height = 0;
    if (glIsTexture(texture) == GL_TRUE) {
        clearErrors();
        glBindTexture(GL_TEXTURE_2D, texture);
        if (takeError() != GL_NO_ERROR)
            return refused(fmt::format("texture {} is not a GL_TEXTURE_2D", texture));
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        glBindTexture(GL_TEXTURE_2D, 0);
    } else {
        return refused(fmt::format("the current context has no texture {}", texture));
    }
    if (width > 0 && height > 0) return TextureSize{width, height};
    return refused(fmt::format("texture {} has no level 0", texture));
}

Diagnostics copyInto(const ForeignTarget& to, const Target& from, bool isOpaque) {
    if (const GLenum before = takeError(); before != GL_NO_ERROR)
        return {allocationError(before, "what was drawn")};
    Name<glDeleteFramebuffers> own;
    std::string name = "the window's framebuffer";
    if (to.texture != 0) {
        name = fmt::format("texture {}", to.texture);
        GLuint made = 0;
        glGenFramebuffers(1, &made);
        own = Name<glDeleteFramebuffers>(made);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, made);
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to.texture, 0);
    } else {
        if (to.framebuffer != 0) {
            name = fmt::format("framebuffer {}", to.framebuffer);
            if (glIsFramebuffer(to.framebuffer) != GL_TRUE)
                return {refused(fmt::format("the current context has no {}", name))};
        }
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
    }
    const std::optional<Diagnostic> problem = problemOfBound(name);
    if (!problem) {
        from.readable().bindForReading();
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glDisable(GL_FRAMEBUFFER_SRGB);
        const auto& [x, y, width, height] = to.rectangle;
        glBlitFramebuffer(0, 0, from.width(), from.height(), x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
        if (isOpaque) makeOpaque(to.rectangle);
    }
    const GLenum failed = takeError();
    from.bind();
    if (problem) return {*problem};
    if (failed != GL_NO_ERROR) return {allocationError(failed, "the picture in " + name)};
    return {};
}

namespace {

/// Something that is off, and that a RasterTracker does not switch.
struct Switch {
    GLenum capability;
    int major = 4, minor = 1;         ///< the version of GL that has it
    std::string_view extension = {};  ///< that it belongs to, if it is none of GL's own
};

constexpr GLenum kDepthBoundsTest = 0x8890;                 // EXT_depth_bounds_test
constexpr GLenum kConservativeRasterization = 0x9346;       // NV_conservative_raster
constexpr GLenum kIntelConservativeRasterization = 0x83FE;  // INTEL_conservative_rasterization

constexpr Switch kSwitches[] = {
    {GL_COLOR_LOGIC_OP},
    {GL_FRAMEBUFFER_SRGB},
    {GL_LINE_SMOOTH},
    {GL_POLYGON_SMOOTH},
    {GL_PRIMITIVE_RESTART},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 4, 3},
    {GL_SAMPLE_ALPHA_TO_ONE},
    {GL_SAMPLE_COVERAGE},
    {GL_SAMPLE_MASK},
    {kDepthBoundsTest, 4, 1, "GL_EXT_depth_bounds_test"},
    {kConservativeRasterization, 4, 1, "GL_NV_conservative_raster"},
    {kIntelConservativeRasterization, 4, 1, "GL_INTEL_conservative_rasterization"},
};

/// A parameter of glPixelStorei that is zero, so that pixels lie in memory packed tightly.
struct PixelStore {
    GLenum name;
    int major = 4, minor = 1;
};

constexpr PixelStore kPixelStores[] = {
    {GL_PACK_SWAP_BYTES},
    {GL_PACK_LSB_FIRST},
    {GL_PACK_ROW_LENGTH},
    {GL_PACK_IMAGE_HEIGHT},
    {GL_PACK_SKIP_ROWS},
    {GL_PACK_SKIP_PIXELS},
    {GL_PACK_SKIP_IMAGES},
    {GL_PACK_COMPRESSED_BLOCK_WIDTH, 4, 2},
    {GL_PACK_COMPRESSED_BLOCK_HEIGHT, 4, 2},
    {GL_PACK_COMPRESSED_BLOCK_DEPTH, 4, 2},
    {GL_PACK_COMPRESSED_BLOCK_SIZE, 4, 2},
    {GL_UNPACK_SWAP_BYTES},
    {GL_UNPACK_LSB_FIRST},
    {GL_UNPACK_ROW_LENGTH},
    {GL_UNPACK_IMAGE_HEIGHT},
    {GL_UNPACK_SKIP_ROWS},
    {GL_UNPACK_SKIP_PIXELS},
    {GL_UNPACK_SKIP_IMAGES},
    {GL_UNPACK_COMPRESSED_BLOCK_WIDTH, 4, 2},
    {GL_UNPACK_COMPRESSED_BLOCK_HEIGHT, 4, 2},
    {GL_UNPACK_COMPRESSED_BLOCK_DEPTH, 4, 2},
    {GL_UNPACK_COMPRESSED_BLOCK_SIZE, 4, 2},
};

/// What others have begun would change what is drawn, or forbid it.
void endWorkOfOthers() {
    // Nothing tells whether rendering is conditional; if it is not, this is an error that nobody is to see.
    glEndConditionalRender();
    GLboolean isActive = GL_FALSE, isPaused = GL_FALSE;
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &isActive);
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &isPaused);
    if (isActive != GL_FALSE && isPaused == GL_FALSE) glPauseTransformFeedback();
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    clearErrors();
}

void setPixelStores(const Capabilities& capabilities) {
    for (const PixelStore& each : kPixelStores)
        if (capabilities.atLeast(each.major, each.minor)) glPixelStorei(each.name, 0);
    if (capabilities.packInvert) glPixelStorei(GL_PACK_INVERT_MESA, GL_FALSE);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
}

/// Bindings that change what calls mean which do not name them.
void unbind(const Capabilities& capabilities) {
    glBindVertexArray(0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (capabilities.atLeast(4, 4)) {
        glBindBuffer(GL_QUERY_BUFFER, 0);
        return glBindSamplers(0, capabilities.combinedTextureUnits, nullptr);
    }
    for (int i = 0; i < capabilities.combinedTextureUnits; ++i) glBindSampler(static_cast<GLuint>(i), 0);
}

void setPrimitives(const Capabilities& capabilities) {
    for (int i = 0; i < capabilities.maxClipDistances; ++i)
        glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    if (capabilities.clipControl) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
    glPrimitiveRestartIndex(0);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    constexpr std::array<GLfloat, 4> kLevels{1, 1, 1, 1};
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, kLevels.data());
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, kLevels.data());
    glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_DONT_CARE);
}

}  // namespace

/// Sets that state whatever the code of others has set: everything of OpenGL 4.6 core, chapter 23, that
/// changes what is drawn, uploaded or read and that a draw, an upload or a readback does not set by itself.
/// A conditional rendering ends, transform feedback pauses, and errors that nobody has asked for are
/// discarded. What belongs to objects stays, as do queries that run.
static void setNeutralState(const Capabilities& capabilities) {
    endWorkOfOthers();
    setInitialState();
    for (const Switch& each : kSwitches)
        if (capabilities.atLeast(each.major, each.minor) &&
            (each.extension.empty() || capabilities.hasExtension(each.extension)))
            glDisable(each.capability);
    setPixelStores(capabilities);
    unbind(capabilities);
    setPrimitives(capabilities);
    RasterTracker raster(capabilities);
    raster.apply({});
    raster.openForClears();
}

void takeBackState(const Context& context) {
    if (context.driver() != Driver::automatic) return;  // nobody else draws with it
    DebugLog& log = context.debugLog();
    // What setNeutralState() tries may be an error that is none of a scene.
    if (log.callsBack()) glDisable(GL_DEBUG_OUTPUT);
    setNeutralState(context.capabilities());
    static_cast<void>(log.take());  // of calls of others
    log.attach(context.capabilities().debugOutput);
}

}  // namespace glibra::gpu
