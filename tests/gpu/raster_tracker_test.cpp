// State set by the tracker against what the driver reports, and the calls that it takes.

#include "gpu/state/state_tracker.h"

#include <functional>

#include "fixture.h"
#include "gpu/context/call_counter.h"
#include "raster_fixture.h"

namespace glibra::gpu {
namespace {

using base::BlendEquation;
using base::BlendFactor;
using base::Comparison;
using base::RasterState;
using base::StencilAction;

GLint integer(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}
GLint indexed(GLenum what, GLuint index) {
    GLint value = 0;
    glGetIntegeri_v(what, index, &value);
    return value;
}

/// A state that differs from the default, and whether the driver reports it.
struct StateCase {
    const char* name;
    std::function<void(RasterState&)> change;
    std::function<bool()> isSet;
};

const std::vector<StateCase>& stateCases() {
    static const std::vector<StateCase> all{
        {"cull", [](RasterState& s) { s.cull = base::Cull::front; },
         [] { return glIsEnabled(GL_CULL_FACE) && integer(GL_CULL_FACE_MODE) == GL_FRONT; }},
        {"cull both", [](RasterState& s) { s.cull = base::Cull::both; },
         [] { return glIsEnabled(GL_CULL_FACE) && integer(GL_CULL_FACE_MODE) == GL_FRONT_AND_BACK; }},
        {"front", [](RasterState& s) { s.front = base::Winding::cw; },
         [] { return integer(GL_FRONT_FACE) == GL_CW; }},
        {"polygon", [](RasterState& s) { s.polygon = base::PolygonMode::point; },
         [] {
             GLint modes[2] = {0, 0};
             glGetIntegerv(GL_POLYGON_MODE, modes);
             return modes[0] == GL_POINT;
         }},
        {"provoking", [](RasterState& s) { s.provoking = base::ProvokingVertex::first; },
         [] { return integer(GL_PROVOKING_VERTEX) == GL_FIRST_VERTEX_CONVENTION; }},
        {"offset",
         [](RasterState& s) {
             s.offsetFactor = 2;
             s.offsetUnits = 4;
         },
         [] {
             GLfloat factor = 0, units = 0;
             glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &factor);
             glGetFloatv(GL_POLYGON_OFFSET_UNITS, &units);
             return glIsEnabled(GL_POLYGON_OFFSET_FILL) && glIsEnabled(GL_POLYGON_OFFSET_LINE) &&
                    glIsEnabled(GL_POLYGON_OFFSET_POINT) && factor == 2 && units == 4;
         }},
        {"depth test", [](RasterState& s) { s.depthTest = false; },
         [] { return !glIsEnabled(GL_DEPTH_TEST); }},
        {"depth function", [](RasterState& s) { s.depthFunction = Comparison::greater; },
         [] { return integer(GL_DEPTH_FUNC) == GL_GREATER; }},
        {"reversed depth",
         [](RasterState& s) {
             s.depthOrder = base::DepthOrder::reversed;
             s.depthFunction = Comparison::less;
             s.depthNear = .25;
             s.offsetUnits = 4;
         },
         [] {
             GLfloat units = 0;
             glGetFloatv(GL_POLYGON_OFFSET_UNITS, &units);
             GLdouble range[2] = {0, 0};
             glGetDoublev(GL_DEPTH_RANGE, range);
             return integer(GL_DEPTH_FUNC) == GL_GREATER && range[0] == 0 && range[1] == .75 && units == -4 &&
                    integer(GL_CLIP_DEPTH_MODE) ==
                        (glad_glClipControl != nullptr ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
         }},
        {"reversed depth of what covers",
         [](RasterState& s) { s.depthOrder = base::DepthOrder::reversedCover; },
         [] {
             return integer(GL_DEPTH_FUNC) == GL_GEQUAL &&
                    integer(GL_CLIP_DEPTH_MODE) == GL_NEGATIVE_ONE_TO_ONE;
         }},
        {"depth write", [](RasterState& s) { s.depthWrite = false; },
         [] { return integer(GL_DEPTH_WRITEMASK) == 0; }},
        {"depth clamp", [](RasterState& s) { s.depthClamp = true; },
         [] { return glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE; }},
        {"depth range",
         [](RasterState& s) {
             s.depthNear = .75;
             s.depthFar = .25;
         },
         [] {
             GLdouble range[2] = {0, 0};
             glGetDoublev(GL_DEPTH_RANGE, range);
             return range[0] == .75 && range[1] == .25;
         }},
        {"stencil",
         [](RasterState& s) {
             s.stencilTest = true;
             s.stencilFront = {Comparison::equal,      3,   0x0f, StencilAction::zero, StencilAction::invert,
                               StencilAction::replace, 0xf0};
             s.stencilBack = {
                 Comparison::notequal,     5,   0x3f, StencilAction::incrementWrap, StencilAction::decrement,
                 StencilAction::increment, 0x7f};
         },
         [] {
             return glIsEnabled(GL_STENCIL_TEST) && integer(GL_STENCIL_FUNC) == GL_EQUAL &&
                    integer(GL_STENCIL_REF) == 3 && integer(GL_STENCIL_VALUE_MASK) == 0x0f &&
                    integer(GL_STENCIL_FAIL) == GL_ZERO && integer(GL_STENCIL_PASS_DEPTH_FAIL) == GL_INVERT &&
                    integer(GL_STENCIL_PASS_DEPTH_PASS) == GL_REPLACE &&
                    integer(GL_STENCIL_WRITEMASK) == 0xf0 && integer(GL_STENCIL_BACK_FUNC) == GL_NOTEQUAL &&
                    integer(GL_STENCIL_BACK_REF) == 5 && integer(GL_STENCIL_BACK_VALUE_MASK) == 0x3f &&
                    integer(GL_STENCIL_BACK_FAIL) == GL_INCR_WRAP &&
                    integer(GL_STENCIL_BACK_PASS_DEPTH_FAIL) == GL_DECR &&
                    integer(GL_STENCIL_BACK_PASS_DEPTH_PASS) == GL_INCR &&
                    integer(GL_STENCIL_BACK_WRITEMASK) == 0x7f;
         }},
        {"blending of all targets", [](RasterState& s) { s.blendAll(base::kBlendOver); },
         [] {
             return glIsEnabledi(GL_BLEND, 0) && glIsEnabledi(GL_BLEND, 7) &&
                    indexed(GL_BLEND_SRC_RGB, 7) == GL_SRC_ALPHA &&
                    indexed(GL_BLEND_DST_RGB, 0) == GL_ONE_MINUS_SRC_ALPHA &&
                    indexed(GL_BLEND_SRC_ALPHA, 0) == GL_ONE &&
                    indexed(GL_BLEND_DST_ALPHA, 0) == GL_ONE_MINUS_SRC_ALPHA;
         }},
        {"blending of one target",
         [](RasterState& s) {
             s.blend[1] = {true,
                           {BlendFactor::constantColor, BlendFactor::one, BlendEquation::reverseSubtract},
                           {BlendFactor::zero, BlendFactor::destinationAlpha, BlendEquation::max}};
             s.blendConstant = {.25, .5, .75, 1};
         },
         [] {
             GLfloat constant[4] = {};
             glGetFloatv(GL_BLEND_COLOR, constant);
             return !glIsEnabledi(GL_BLEND, 0) && glIsEnabledi(GL_BLEND, 1) && !glIsEnabledi(GL_BLEND, 2) &&
                    indexed(GL_BLEND_SRC_RGB, 1) == GL_CONSTANT_COLOR &&
                    indexed(GL_BLEND_DST_RGB, 1) == GL_ONE && indexed(GL_BLEND_SRC_ALPHA, 1) == GL_ZERO &&
                    indexed(GL_BLEND_DST_ALPHA, 1) == GL_DST_ALPHA &&
                    indexed(GL_BLEND_EQUATION_RGB, 1) == GL_FUNC_REVERSE_SUBTRACT &&
                    indexed(GL_BLEND_EQUATION_ALPHA, 1) == GL_MAX && constant[0] == .25F &&
                    constant[2] == .75F;
         }},
        {"write masks",
         [](RasterState& s) {
             s.write.fill({true, false, false, true});
             s.write[2] = {false, true, true, false};
         },
         [] {
             GLboolean first[4] = {}, third[4] = {};
             glGetBooleani_v(GL_COLOR_WRITEMASK, 0, first);
             glGetBooleani_v(GL_COLOR_WRITEMASK, 2, third);
             return first[0] && !first[1] && !first[2] && first[3] && !third[0] && third[1] && third[2] &&
                    !third[3];
         }},
        {"multisample", [](RasterState& s) { s.multisample = false; },
         [] { return !glIsEnabled(GL_MULTISAMPLE); }},
        {"alpha to coverage", [](RasterState& s) { s.alphaToCoverage = true; },
         [] { return glIsEnabled(GL_SAMPLE_ALPHA_TO_COVERAGE) == GL_TRUE; }},
        {"sample shading", [](RasterState& s) { s.sampleShading = .5; },
         [] {
             GLfloat fraction = 0;
             glGetFloatv(GL_MIN_SAMPLE_SHADING_VALUE, &fraction);
             return glIsEnabled(GL_SAMPLE_SHADING) && fraction == .5F;
         }},
        {"viewport", [](RasterState& s) { s.viewport = {.5, .25, .5, .5}; },
         [] {
             GLint rectangle[4] = {};
             glGetIntegerv(GL_VIEWPORT, rectangle);
             return rectangle[0] == 50 && rectangle[1] == 10 && rectangle[2] == 50 && rectangle[3] == 20;
         }},
        {"scissor", [](RasterState& s) { s.scissor = base::FractionRectangle{.1, .1, .2, .3}; },
         [] {
             GLint rectangle[4] = {};
             glGetIntegerv(GL_SCISSOR_BOX, rectangle);
             return glIsEnabled(GL_SCISSOR_TEST) && rectangle[0] == 10 && rectangle[1] == 4 &&
                    rectangle[2] == 20 && rectangle[3] == 12;
         }},
        {"point size", [](RasterState& s) { s.pointSize = 3; },
         [] {
             GLfloat size = 0;
             glGetFloatv(GL_POINT_SIZE, &size);
             return size == 3;
         }},
        {"point size from the shader", [](RasterState& s) { s.pointSizeFromShader = true; },
         [] { return glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE; }},
    };
    return all;
}

class RasterTrackerTest : public test::RasterTest {};

TEST_F(RasterTrackerTest, EveryStateReachesTheDriverAndGoesAgain) {
    // The driver reports stencil references only as far as the stencil buffer holds them.
    const auto stencil =
        Texture::create(driver(), TextureShape::texture2D, TexelFormat::depth24_stencil8, {100, 40});
    ASSERT_TRUE(stencil);
    const auto target = Target::parts(driver(), {}, TexturePart{&*stencil});
    ASSERT_TRUE(target) << test::text(target.diagnostics);
    target->bind();
    RasterTracker tracker(driver());
    tracker.targetBound(100, 40);
    tracker.apply({});
    for (const StateCase& each : stateCases()) {
        SCOPED_TRACE(each.name);
        EXPECT_FALSE(each.isSet()) << "before";
        RasterState state;
        each.change(state);
        tracker.apply(state);
        EXPECT_TRUE(each.isSet());
        tracker.apply({});
        EXPECT_FALSE(each.isSet()) << "after";
    }
}

TEST_F(RasterTrackerTest, TheDefaultIsTheStateAtTheBeginningOfAPass) {
    RasterTracker(driver()).apply({});
    EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
    EXPECT_EQ(integer(GL_DEPTH_FUNC), GL_LEQUAL);
    for (const GLenum off : std::initializer_list<GLenum>{GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST,
                                                          GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL})
        EXPECT_FALSE(glIsEnabled(off)) << off;
}

TEST_F(RasterTrackerTest, EqualStateTakesNoCall) {
    RasterTracker tracker(driver());
    for (const StateCase& each : stateCases()) {
        SCOPED_TRACE(each.name);
        RasterState state;
        each.change(state);
        tracker.apply(state);
        const CallCounter counter;
        tracker.apply(state);
        EXPECT_EQ(counter.counts().calls, 0U);
    }
}

TEST_F(RasterTrackerTest, OneChangeTakesFewCalls) {
    RasterTracker tracker(driver());
    tracker.apply({});
    RasterState state;
    const auto callsFor = [&](const std::function<void(RasterState&)>& change) {
        change(state);
        const CallCounter counter;
        tracker.apply(state);
        return counter.counts().calls;
    };
    EXPECT_EQ(callsFor([](RasterState& s) { s.depthWrite = false; }), 1U);
    EXPECT_EQ(callsFor([](RasterState& s) { s.blendAll(base::kBlendOver); }), 4U)
        << "glEnable, glBlendFuncSeparate, glBlendEquationSeparate, glBlendColor";
    EXPECT_EQ(callsFor([](RasterState& s) { s.blendAll({}); }), 1U);
    EXPECT_EQ(callsFor([](RasterState& s) { s.blendAll(base::kBlendOver); }), 1U);
    EXPECT_EQ(callsFor([](RasterState& s) { s.write[3].red = false; }), 1U);
}

TEST_F(RasterTrackerTest, ForgottenStateIsSetAgain) {
    RasterTracker tracker(driver());
    tracker.apply({});
    glEnable(GL_CULL_FACE);
    tracker.apply({});
    EXPECT_TRUE(glIsEnabled(GL_CULL_FACE)) << "not seen by the tracker";
    tracker.forget();
    tracker.apply({});
    EXPECT_FALSE(glIsEnabled(GL_CULL_FACE));
    RasterState reversed;
    reversed.depthOrder = base::DepthOrder::reversed;
    tracker.apply(reversed);
    tracker.forget();
    tracker.apply({});
    EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_NEGATIVE_ONE_TO_ONE) << "nobody else sets it";
}

TEST_F(RasterTrackerTest, RectanglesThatShareAnEdgeMeet) {
    for (const int width : {7, 100, 101, 333}) {
        int right = 0;
        for (int i = 0; i < 3; ++i) {
            const PixelRectangle part = pixelsOf({i / 3., 0, 1 / 3., 1}, width, 5);
            EXPECT_EQ(part.x, right);
            right = part.x + part.width;
        }
        EXPECT_EQ(right, width);
    }
}

}  // namespace
}  // namespace glibra::gpu
