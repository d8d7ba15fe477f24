// --max-error and Bound: what is chosen is measured again, in pictures of full size against the finest
// values.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "budget/contour_shift.h"
#include "modern_text.h"

namespace glibra::test {
namespace {

/// A scene with the decisions that were made for it.
struct BoundScene {
    explicit BoundScene(const std::string& scene, const RenderOptions& options) : folder(scene, {}) {
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        messages = text(loaded.diagnostics);
        renderer = std::move(loaded.value);
    }
    [[nodiscard]] double value(const std::string& name) const {
        for (const scene::Variable& each : renderer->scene().variables)
            if (each.name == name) return each.current.front();
        ADD_FAILURE() << name;
        return 0;
    }
    [[nodiscard]] std::string why(const std::string& name) const {
        for (const budget::Decision& each : stats.decisions)
            if (each.what == name) return each.why;
        return {};
    }
    [[nodiscard]] image::Image picture(double time) {
        Result<image::Image> drawn = renderer->draw(time, stats);
        EXPECT_TRUE(drawn) << text(drawn.diagnostics);
        return drawn ? std::move(*drawn) : image::Image{};
    }

    SceneFolder folder;
    render::Stats stats;
    std::string messages;
    std::optional<render::SceneRenderer> renderer;
};

const std::string kFill = R"(in vec2 vST;
out vec4 fColor;
)";

/// One scene for each kind of value that may be chosen.
struct BoundKind {
    const char* name;
    std::string scene;
    std::vector<std::string> variables;
    double time = 0;
};

std::vector<BoundKind> boundKinds() {
    const std::string vertex = R"(Vertex inline
#version 330 core
in vec3 position;
uniform mat4 mvp, uToShadow;
out vec4 vShadow;
void main() {{
    vShadow = uToShadow * vec4(position, 1.);
    gl_Position = mvp * vec4(position, 1.);
}}
EndVertex
)";
    const std::string shadow = R"(WindowSize 400 400
Camera eye LookAt 0 4 5  0 0 0  0 1 0  Perspective 50 .1 50
Camera light LookAt 3 5 2  0 0 0  0 1 0  Perspective 50 1 15  aspect 1
{0}
Texture2D shadow ({1}) ({1}) depth32f
)" + vertex + "Program Depth\n" +
                               vertex + R"(Fragment inline
#version 330 core
in vec4 vShadow;
uniform sampler2DShadow uShadow;
uniform int uGrid;
uniform float uWidth;
out vec4 fColor;
void main() {{
    float sum = 0.;
    for (int i = 0; i < uGrid; ++i)
        for (int j = 0; j < uGrid; ++j) {{
            vec2 at = uWidth * ((vec2(i, j) + .5) / float(uGrid) - .5);
            sum += textureProj(uShadow, vShadow + vec4(at * vShadow.w, -.002, 0.));
        }}
    fColor = vec4(vec3(.2 + .7 * sum / float(uGrid * uGrid)), 1.);
}}
EndFragment
Program Lit uShadow shadow uToShadow (light.shadow * model) {2}
Group world
    Plane 4
    Translate 0 .6 0
    Torus .2 .6 32 64
EndGroup
Pass shadow from light
    State offset {3}
    Use Depth
    Draw world
EndPass
Pass window from eye
    Use Lit
    Draw world
EndPass
)";
    std::vector<BoundKind> kinds;
    kinds.push_back(
        {"size of a shadow map",
         fmt::format(fmt::runtime(shadow), "Bound texels <64 512 4096>", "texels", "uGrid 1 uWidth 0", "2 4"),
         {"texels"}});
    kinds.push_back({"offset and size of a shadow map",
                     fmt::format(fmt::runtime(shadow), "Bound texels <64 512 4096>\nBound factor <16 4 1>",
                                 "texels", "uGrid 1 uWidth 0", "(factor) 4"),
                     {"texels", "factor"}});
    kinds.push_back(
        {"samples of a soft shadow",
         fmt::format(fmt::runtime(shadow), "Bound across <1 4 32>", "2048", "uGrid across uWidth .05", "2 4"),
         {"across"}});
    kinds.push_back({"size of a render target",
                     R"(WindowSize 400 400
Bound side <32 200 1600>
Texture2D picture (side) (side) rgba8 linear clamp
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 50 .1 50
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2D uPicture;
out vec4 fColor;
void main() { fColor = texture(uPicture, vST); }
EndFragment
Program Show uPicture picture
Fragment inline
#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1., .8, .4, 1.); }
EndFragment
Vertex inline
#version 330 core
in vec3 position;
uniform mat4 mvp;
void main() { gl_Position = mvp * vec4(position, 1.); }
EndVertex
Program Plain
Pass picture from eye clear {.1 .1 .3}
    Use Plain
    Rotate 30 1 2 0
    Torus .4 .9 60 90
EndPass
Fill window with Show
)",
                     {"side"}});
    kinds.push_back({"steps of a ray marcher",
                     R"(WindowSize 400 400
Bound steps <4 64 1024>
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 50 .1 50
Fragment inline
#version 330 core
in vec2 vST;
uniform float steps;
out vec4 fColor;
void main() {
    vec3 o = vec3(2. * vST - 1., -1.5), d = normalize(vec3(.2 * (vST - .5), 1.));
    float length = 3. / steps, light = 0., left = 1.;
    for (float i = 0.; i < steps; ++i) {
        vec3 p = o + (i + .5) * length * d;
        float density = 6. * max(0., .8 - dot(p, p)) * (1.2 + sin(9. * p.x) * sin(9. * p.y + 4. * p.z));
        float seen = exp(-density * length);
        light += left * (1. - seen) * (.6 + .4 * p.y);
        left *= seen;
    }
    fColor = vec4(vec3(light), 1.);
}
EndFragment
Program March
Fill window with March
)",
                     {"steps"}});
    kinds.push_back({"steps of a simulation",
                     R"(WindowSize 400 400
Bound rate <4 60 1920>
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 50 .1 50
Texture2D state 1 1 rgba32f history
Fragment inline
#version 330 core
out vec4 fColor;
void main() { fColor = vec4(.7, 0., 0., 0.); }
EndFragment
Program Seed
Fragment inline
#version 330 core
uniform sampler2D uLast;
uniform float uDt;
out vec4 fColor;
void main() {
    vec4 last = texelFetch(uLast, ivec2(0), 0);
    vec2 speed = last.zw - uDt * last.xy;
    fColor = vec4(last.xy + uDt * (last.zw + vec2(0., .3)), speed);
}
EndFragment
Program Move uLast state.prev uDt (dt)
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2D uState;
out vec4 fColor;
void main() {
    vec2 p = texelFetch(uState, ivec2(0), 0).xy;
    fColor = vec4(vec3(smoothstep(.3, .29, length(2. * vST - 1. - p))), 1.);
}
EndFragment
Program Show uState state
Once
    Fill state with Seed
EndOnce
Step (rate)
    Fill state with Move
EndStep
Fill window with Show
)",
                     {"rate"},
                     1.5});
    kinds.push_back({"size of a noise volume",
                     R"(WindowSize 400 400
Bound texels <16 64 256>
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 50 .1 50
Texture3D volume (texels) (texels) (texels) r16f linear repeat
Compute inline
#version 430 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r16f) uniform writeonly image3D uVolume;
void main() {
    vec3 p = (vec3(gl_GlobalInvocationID) + .5) / vec3(imageSize(uVolume)) * 6.28318530718;
    float sum = sin(3. * p.x + 2. * sin(2. * p.y)) * sin(4. * p.y + sin(p.z)) + .5 * sin(7. * p.z + 5. * p.x);
    imageStore(uVolume, ivec3(gl_GlobalInvocationID), vec4(sum));
}
EndCompute
Program Make uVolume volume
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler3D uVolume;
out vec4 fColor;
void main() { fColor = vec4(vec3(step(0., texture(uVolume, vec3(vST, .3 + .2 * vST.x)).r)), 1.); }
EndFragment
Program Show uVolume volume
Once
    Dispatch Make over volume
EndOnce
Fill window with Show
)",
                     {"texels"}});
    return kinds;
}

TEST(Bounds, KeepTheBoundInPicturesOfFullSizeForEveryKind) {
    double worst = 0;
    for (const BoundKind& kind : boundKinds()) {
        const bool needsCompute = kind.scene.find("Compute") != std::string::npos;
        if (needsCompute && !sharedContext().capabilities().compute) continue;
        bool isCoarserSomewhere = false;
        for (const double maxError : {.5, 1., 4.}) {
            RenderOptions options;
            options.time = kind.time;
            options.maxError = maxError;
            BoundScene chosen(kind.scene, options);
            ASSERT_TRUE(chosen.renderer) << kind.name;
            // Nothing is promised where the small pictures do not settle.
            if (chosen.messages.find("may break the bound") != std::string::npos) continue;
            RenderOptions coarse, fine;
            std::string values;
            for (const std::string& each : kind.variables) {
                double finest = 0;
                for (const scene::Variable& known : chosen.renderer->scene().variables)
                    if (known.name == each && known.bound) finest = known.bound->finest;
                const double value = chosen.value(each);
                values += fmt::format(" {}={}", each, value);
                coarse.set.push_back(fmt::format("{}={}", each, value));
                fine.set.push_back(fmt::format("{}={}", each, finest));
                isCoarserSomewhere |= value != finest;
                EXPECT_NE(chosen.why(each).find("against the finest"), std::string::npos) << chosen.why(each);
            }
            BoundScene byValue(kind.scene, coarse), finest(kind.scene, fine);
            const budget::ContourShifts shifts(byValue.picture(kind.time), finest.picture(kind.time));
            const double off = shifts.ofChangesAbove(8. / 255);
            const double colored = shifts.shareOfSmoothChangesAbove(8. / 255, off);
            std::printf("%s, %g px: %s off by %.3f px, %.2f of 1000 with another colour; %s\n", kind.name,
                        maxError, values.c_str(), off, 1000 * colored, chosen.why(kind.variables[0]).c_str());
            EXPECT_LE(off, maxError) << kind.name << values;
            EXPECT_LE(colored, .002) << kind.name << values;
            worst = std::max(worst, off / maxError);
        }
        EXPECT_TRUE(isCoarserSomewhere) << kind.name;
    }
    std::printf("worst ratio of error and bound: %.3f\n", worst);
}

TEST(Bounds, ChangeNothingWithoutMaxErrorAndNothingThatSetStates) {
    const BoundKind kind = boundKinds()[0];
    std::string asLet = kind.scene;
    asLet.replace(asLet.find("Bound"), 5, "Let");
    BoundScene bound(kind.scene, {}), let(asLet, {});
    EXPECT_EQ(bound.picture(0).data, let.picture(0).data);
    EXPECT_TRUE(bound.stats.decisions.empty());
    RenderOptions options;
    options.maxError = 4;
    options.set = {"texels=1000"};
    const BoundScene stated(kind.scene, options);
    EXPECT_EQ(stated.value("texels"), 1000);
    EXPECT_EQ(stated.why("texels"), "1000 kept: stated by --set");
}

TEST(Bounds, SayWhenNothingCanBeMeasured) {
    // Each value has a noise of its own.
    const std::string noise = R"(WindowSize 200 200
Bound n <8 64 512>
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 50 .1 50
Fragment inline
#version 330 core
uniform float n;
out vec4 fColor;
void main() { fColor = vec4(vec3(fract(sin(dot(floor(gl_FragCoord.xy / 5.), vec2(12.9, 78.2)) + n) * 43758.5)), 1.); }
EndFragment
Program Noise
Fill window with Noise
)";
    RenderOptions options;
    options.maxError = 1;
    const BoundScene scene(noise, options);
    EXPECT_EQ(scene.value("n"), 64);
    EXPECT_NE(scene.messages.find("draw-W07"), std::string::npos) << scene.messages;
    EXPECT_NE(scene.why("n").find("64 kept: its error is not known"), std::string::npos) << scene.why("n");
}

}  // namespace
}  // namespace glibra::test
