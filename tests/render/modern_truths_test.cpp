// Modern scenes against independent truths: shadows and reflections against rays that are cast in double
// precision, compared depth against depth read raw, cube maps that are drawn against cube maps from files,
// two eyes without a distance.

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "image/write.h"
#include "modern_text.h"

namespace glibra::test {
namespace {

using Vec = glm::dvec3;

/// An eye with a symmetrical perspective.
struct Camera {
    Vec place, right, up, back;
    double slope = 1, aspect = 1;  ///< tangent of half the vertical angle; width / height

    static Camera lookingAt(Vec eye, Vec centre, double degrees, double aspect) {
        const Vec back = glm::normalize(eye - centre);
        const Vec right = glm::normalize(glm::cross(Vec(0, 1, 0), back));
        return {eye, right, glm::cross(back, right), back, std::tan(degrees * std::acos(-1.) / 360), aspect};
    }
    /// The ray through a point of the picture, which is -1..1 in both axes.
    [[nodiscard]] Vec ray(glm::dvec2 at) const {
        return at.x * slope * aspect * right + at.y * slope * up - back;
    }
    [[nodiscard]] glm::dvec2 seen(Vec point) const {
        const Vec from = point - place;
        const double depth = -glm::dot(from, back);
        return {glm::dot(from, right) / (depth * slope * aspect), glm::dot(from, up) / (depth * slope)};
    }
};

/// A box with its own axes.
struct Crate {
    Vec centre, half;
    glm::dmat3 axes{1.0};

    /// How far along the ray it is hit; nothing if it is missed.
    [[nodiscard]] std::optional<double> hit(Vec from, Vec ray) const {
        double enter = 0, leave = 1e300;
        for (int i = 0; i < 3; ++i) {
            const double start = glm::dot(axes[i], from - centre), speed = glm::dot(axes[i], ray);
            double first = (-half[i] - start) / speed, last = (half[i] - start) / speed;
            if (first > last) std::swap(first, last);
            enter = std::max(enter, first);
            leave = std::min(leave, last);
        }
        return enter <= leave ? std::optional(enter) : std::nullopt;
    }
};

/// The columns of a right-handed rotation. J. Gray Rodrigues, 1840.
glm::dmat3 turned(double degrees, Vec axis) {
    const double angle = degrees * std::acos(-1.) / 180;
    const Vec n = glm::normalize(axis);
    glm::dmat3 made;
    for (int i = 0; i < 3; ++i) {
        Vec e(0);
        e[i] = 1;
        made[i] = std::cos(angle) * e + std::sin(angle) * glm::cross(n, e) + (1 - std::cos(angle)) * n[i] * n;
    }
    return made;
}

/// The value that a function has in a whole square about a point, sampled 9 times 9; nothing if it changes.
std::optional<int> steady(const std::function<int(glm::dvec2)>& value, glm::dvec2 centre, double half) {
    const int first = value(centre - half);
    for (int y = 0; y <= 8; ++y)
        for (int x = 0; x <= 8; ++x)
            if (value(centre + half * glm::dvec2(x / 4. - 1, y / 4. - 1)) != first) return std::nullopt;
    return first;
}

/// The centre of a pixel, -1..1; rows count from the top.
glm::dvec2 centreOf(int x, int y, int width, int height) {
    return {(x + .5) / width * 2 - 1, 1 - (y + .5) / height * 2};
}

constexpr const char* kPlainVertex = R"(Vertex inline
#version 330 core
in vec4 aVertex;
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
)";

// ---- Shadows.

constexpr int kMap = 256, kWindow = 320;
constexpr double kSlack = 1 / 64.;  ///< of a texel: what rasterisation and interpolation round

std::string shadowScene(const std::string& filter) {
    return R"(WindowSize 320 320
Camera eye LookAt 1 7 4  0 0 0  0 1 0  Perspective 40 1 30
Camera light LookAt 3 6 2  0 .5 0  0 1 0  Perspective 40 2 12
Texture2D shadow 256 256 depth32f )" +
           filter + "\n" + kPlainVertex + R"(Program Depth
Vertex inline
#version 330 core
in vec4 aVertex;
uniform mat4 uShadowMatrix;
out vec4 vShadow;
void main() {
    vShadow = uShadowMatrix * aVertex;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
EndVertex
Fragment inline
#version 330 core
in vec4 vShadow;
uniform sampler2DShadow uShadow;
out vec4 fColor;
void main() { fColor = vec4(vec3(textureProj(uShadow, vShadow)), 1.); }
EndFragment
Program Lit uShadow shadow uShadowMatrix (light.shadow * model)
Pass shadow from light
    Use Depth
    Translate .25 1.2 0
    Rotate 30 1 2 3
    Box 1 1.5 .8
EndPass
Pass window from eye
    Use Lit
    QuadXZ 0 20 1 1
EndPass
)";
}

TEST(ModernTruths, ShadowsEndWhereRaysToTheLightAreBlocked) {
    // A texel of the map is covered if the ray through its centre hits the box. A picture point reads the
    // texel that it lies in, so up to half a texel beside it; with the linear filter the four around it, so
    // up to one texel beside it. Where all rays of that square agree, the picture must be exactly theirs.
    const Camera eye = Camera::lookingAt({1, 7, 4}, {0, 0, 0}, 40, 1);
    const Camera light = Camera::lookingAt({3, 6, 2}, {0, .5, 0}, 40, 1);
    const Crate box{{.25, 1.2, 0}, {.5, .75, .4}, turned(30, {1, 2, 3})};
    const std::function<int(glm::dvec2)> isLit = [&](glm::dvec2 texel) {
        return box.hit(light.place, light.ray(texel / double(kMap) * 2. - 1.)) ? 0 : 255;
    };
    for (const bool isLinear : {false, true}) {
        TextScene scene(shadowScene(isLinear ? "linear" : "nearest"));
        const image::Image picture = scene.draw();
        ASSERT_EQ(picture.width, kWindow);
        int dark = 0, undecided = 0, wrong = 0;
        glm::dvec2 foundCentre(0), exactCentre(0);  ///< sums, in texels of the map
        double foundArea = 0, exactArea = 0;
        for (int y = 0; y < kWindow; ++y)
            for (int x = 0; x < kWindow; ++x) {
                const Vec ray = eye.ray(centreOf(x, y, kWindow, kWindow));
                const Vec point = eye.place - ray * (eye.place.y / ray.y);
                const glm::dvec2 texel = (light.seen(point) + 1.) * (kMap / 2.);
                const int found = byteAt(picture, x, y);
                const double covered = 1 - found / 255., blocked = 1 - isLit(texel) / 255.;
                foundCentre += covered * texel;
                foundArea += covered;
                exactCentre += blocked * texel;
                exactArea += blocked;
                if (const auto exact = steady(isLit, texel, (isLinear ? 1 : .5) + kSlack)) {
                    wrong += found == *exact ? 0 : 1;
                    dark += *exact == 0 ? 1 : 0;
                } else {
                    ++undecided;
                }
            }
        EXPECT_EQ(wrong, 0) << (isLinear ? "linear" : "nearest");
        EXPECT_GT(dark, 1500);
        EXPECT_LT(undecided, 3500);
        EXPECT_GT(undecided, 200);
        // The errors along the edge cancel: the shadow is not moved by a quarter of a texel, and not grown.
        EXPECT_LT(glm::length(foundCentre / foundArea - exactCentre / exactArea), .2);
        EXPECT_LT(std::abs(foundArea - exactArea) / undecided, .05);
    }
}

TEST(ModernTruths, ComparedDepthIsThatOfDepthReadRaw) {
    TextScene scene(std::string(R"(WindowSize 200 200
Camera light LookAt 3 4 5  0 0 0  0 1 0  Perspective 50 2 12
Texture2D shadow 200 200 depth32f nearest
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2DShadow uCompared;
uniform sampler2D uRaw;
out vec4 fColor;
void main() {
    float reference = .55 + .4 * fract(dot(floor(gl_FragCoord.xy), vec2(.61803, .41421)));
    float raw = texture(uRaw, vST).r;
    // Some references are exactly the stored depth.
    if (mod(floor(gl_FragCoord.x), 3.) == 0.) reference = raw;
    fColor = vec4(texture(uCompared, vec3(vST, reference)), reference <= raw ? 1. : 0., raw, 1.);
}
EndFragment
Program Show uCompared shadow uRaw shadow
Fragment
)") + kPlainVertex + R"(Program Depth
Pass shadow from light
    Use Depth
    Torus .6 1.3 24 48
    QuadXZ -1 3 1 1
EndPass
Fill window with Show
)");
    const image::Image picture = scene.draw();
    std::array<int, 2> counts{};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            EXPECT_EQ(byteAt(picture, x, y, 0), byteAt(picture, x, y, 1));
            ++counts.at(byteAt(picture, x, y, 0) == 255 ? 1 : 0);
        }
    EXPECT_GT(counts[0], 2000);
    EXPECT_GT(counts[1], 2000);
}

// ---- Flat water.

TEST(ModernTruths, FlatWaterShowsWhatMirroredRaysHit) {
    constexpr int kWidth = 240, kHeight = 180, kTexels = 120;
    struct Colored {
        Crate crate;
        int color;
    };
    // One reaches into the water, one lies below it and has no reflection.
    const std::vector<Colored> crates{{{{-1, .5, -2}, {.6, 1, .5}, turned(25, {0, 1, 0})}, 51},
                                      {{{.8, 1.1, -3}, {.7, .9, .4}, turned(40, {1, 1, 0})}, 102},
                                      {{{-.3, 2.2, -5}, {1.5, .5, .3}, turned(10, {0, 0, 1})}, 153},
                                      {{{0, -1, -2}, {1, .5, 1}, turned(0, {0, 1, 0})}, 204}};
    std::string drawn;
    for (const char* each : {"Translate -1 .5 -2\nRotate 25 0 1 0\nSet uGrey .2\nBox 1.2 2 1\n",
                             "Translate .8 1.1 -3\nRotate 40 1 1 0\nSet uGrey .4\nBox 1.4 1.8 .8\n",
                             "Translate -.3 2.2 -5\nRotate 10 0 0 1\nSet uGrey .6\nBox 3 1 .6\n",
                             "Translate 0 -1 -2\nSet uGrey .8\nBox 2 1 2\n"})
        drawn += "Group\n" + std::string(each) + "EndGroup\n";
    TextScene scene(std::string(R"(WindowSize 240 180
Camera eye LookAt 0 3 6  0 .2 -1  0 1 0  Perspective 30 1 60
Camera below Reflect eye 0 1 0 0 clip
Texture2D reflection 120 90 rgba8 nearest clamp
)") + kPlainVertex + R"(Fragment inline
#version 330 core
uniform float uGrey;
out vec4 fColor;
void main() { fColor = vec4(vec3(uGrey), 1.); }
EndFragment
Program Flat
Vertex inline
#version 330 core
in vec4 aVertex;
out vec4 vClip;
void main() { gl_Position = vClip = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330 core
in vec4 vClip;
uniform sampler2D uReflection;
out vec4 fColor;
void main() { fColor = texture(uReflection, vClip.xy / vClip.w * .5 + .5); }
EndFragment
Program Water uReflection reflection
Pass reflection from below clear {0 0 0}
Use Flat
)" + drawn + R"(EndPass
Pass window from eye clear {0 0 0}
Use Water
QuadXZ 0 50 1 1
EndPass
)");
    const image::Image picture = scene.draw();
    const Camera eye = Camera::lookingAt({0, 3, 6}, {0, .2, -1}, 30, double(kWidth) / kHeight);
    const std::function<int(glm::dvec2)> mirrored = [&](glm::dvec2 texel) {
        Vec ray = eye.ray({texel.x / kTexels * 2 - 1, texel.y / (kTexels * kHeight / kWidth) * 2 - 1});
        if (ray.y >= 0) return 0;
        const Vec point = eye.place - ray * (eye.place.y / ray.y);
        ray.y = -ray.y;
        double nearest = 1e300;
        int color = 0;
        for (const Colored& each : crates)
            if (const auto at = each.crate.hit(point, ray); at && *at < nearest && *at >= 0) {
                nearest = *at;
                color = each.color;
            }
        return color;
    };
    std::map<int, int> counts;
    int undecided = 0, wrong = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const glm::dvec2 texel = (centreOf(x, y, kWidth, kHeight) + 1.) * glm::dvec2(kTexels, 90) * .5;
            const auto exact = steady(mirrored, texel, .5 + kSlack);
            undecided += exact ? 0 : 1;
            if (!exact) continue;
            ++counts[*exact];
            wrong += byteAt(picture, x, y) == *exact ? 0 : 1;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_LT(undecided, kWidth * kHeight / 12);
    for (const int color : {0, 51, 102, 153}) EXPECT_GT(counts[color], 200) << color;
    EXPECT_EQ(counts[204], 0) << "what lies in the water has no reflection";
}

// ---- Cube maps.

constexpr const char* kLook = R"(Fragment inline
#version 330 core
in vec2 vST;
uniform samplerCube uRoom;
out vec4 fColor;
void main() {
    float a = (vST.s - .5) * 6.28318, b = (vST.t - .5) * 3.14159;
    fColor = texture(uRoom, vec3(cos(b) * cos(a), sin(b), cos(b) * sin(a)));
}
EndFragment
Program Look uRoom room
Fragment
)";

TEST(ModernTruths, FacesThatAreDrawnAreThoseOfFiles) {
    for (const std::string filter : {"nearest", "linear"}) {
        std::string faces;
        for (int i = 0; i < 6; ++i) {
            const std::string n = std::to_string(i);
            faces += "Camera side" + n + " Face " + n + " .1 .2 -.3 .05 20\n";
            faces += "Pass room.face(" + n + ") from side" + n +
                     "\nUse Paint\nSphere 4 24 24\nTranslate 1 .5 1\n" +
                     "Box .5\nTranslate -2 0 -3\nBox 1\nEndPass\n";
        }
        TextScene drawn("WindowSize 240 120\nCubeMap room 48 rgba8 " + filter + " clamp\n" + kLook +
                        R"(Vertex inline
#version 330 core
in vec4 aVertex;
out vec3 vPlace;
void main() {
    vPlace = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
EndVertex
Fragment inline
#version 330 core
in vec3 vPlace;
out vec4 fColor;
void main() { fColor = vec4(fract(vPlace * 1.3 + .1), 1.); }
EndFragment
Program Paint
)" + faces + "Fill window with Look\n");
        const image::Image picture = drawn.draw();
        const SceneFolder files("");
        std::string names;
        for (int i = 0; i < 6; ++i) {
            const std::string name = "face" + std::to_string(i) + ".png";
            const Diagnostics problems = image::writeImage(drawn.texture("room", i), files / name);
            ASSERT_TRUE(problems.empty()) << text(problems);
            names += " \"" + (files / name).string() + "\"";
        }
        TextScene read("WindowSize 240 120\nCubeMap room" + names + " " + filter + " clamp\n" + kLook +
                       "Fill window with Look\n");
        const image::Image again = read.draw();
        EXPECT_EQ(picture.data, again.data) << filter;
        EXPECT_GT(std::set<std::byte>(picture.data.begin(), picture.data.end()).size(), 50U);
    }
}

// ---- Two eyes.

TEST(ModernTruths, TwoEyesWithoutADistanceSeeOnePicture) {
    const std::string world =
        std::string("Camera eye LookAt 1 2 5  0 0 0  0 1 0  Perspective 50 .1 100 aspect 1\n") +
        "Group world\nRotate 20 1 1 0\nColor .9 .5 .3\nTorus .4 1 24 48\nTranslate 1 0 0\n"
        "Color .2 .6 .9\nBox 1\nEndGroup\n";
    TextScene mono("WindowSize 160 160\n" + world + "Pass window from eye\nDraw world\nEndPass\n");
    const image::Image one = mono.draw();
    TextScene anaglyph("WindowSize 160 160\nLet iod 0\n" + world +
                       "Camera left Shift eye (-iod/2) 0 0\nCamera right Shift eye (iod/2) 0 0\n"
                       "Pass window from left\nState write r\nDraw world\nEndPass\n"
                       "Pass window from right keep color\nState write gb\nDraw world\nEndPass\n");
    EXPECT_EQ(anaglyph.draw().data, one.data);
    RenderOptions both;
    both.wantedObjects = {"one", "two"};
    TextScene pair(
        "WindowSize 160 160\nLet iod 0\nTexture2D one 160 160 rgba8\nTexture2D two 160 160 rgba8\n" + world +
            "Camera left Shift eye (-iod/2) 0 0\nCamera right Shift eye (iod/2) 0 0\n"
            "Pass one from left\nDraw world\nEndPass\nPass two from right\nDraw world\nEndPass\n"
            "Pass window from eye\nDraw world\nEndPass\n",
        {}, both);
    EXPECT_EQ(pair.draw().data, one.data);
    EXPECT_EQ(pair.texture("one").data, pair.texture("two").data);
    EXPECT_EQ(byteAt(pair.texture("one"), 80, 70), byteAt(one, 80, 70));
    EXPECT_GT(std::set<std::byte>(one.data.begin(), one.data.end()).size(), 5U);
}

}  // namespace
}  // namespace glibra::test
