#include "gpu/state/neutral_state.h"

#include <glad/gl.h>

#include <array>
#include <string_view>

#include "gpu/context/errors.h"
#include "gpu/state/raster_tracker.h"

namespace glibra::gpu {
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

void setNeutralState(const Capabilities& capabilities) {
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
