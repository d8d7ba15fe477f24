// What textures hold after a shader has written to them, in every format, against the exact quantisation; and
// draw state whose effect is a number: polygon offset, provoking vertex, alpha to coverage.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/texel_format.h"
#include "modern_text.h"

namespace glibra::test {
namespace {

using base::TexelClass;
using base::TexelFormat;

constexpr int kRowTexels = 64;

/// The values of a texture's texel, by component.
std::size_t indexOf(int x, std::size_t component) {
    return (static_cast<std::size_t>(x) + 16 * component) % kRowTexels;
}

std::string listOf(const std::vector<double>& values) {
    std::string list = "[";
    char digits[40];
    for (const double each : values) {
        std::snprintf(digits, sizeof digits, "%.17g ", each);
        list += digits;
    }
    return list + "]";
}

/// A texture of 64 texels whose components a shader has written, each from a list of 64 values.
std::string writeScene(const base::TexelFormatRow& row, const std::vector<double>& values) {
    const std::string kind = row.kind == TexelClass::integer           ? "i"
                             : row.kind == TexelClass::unsignedInteger ? "u"
                                                                       : "";
    const std::string number = kind.empty() ? "float" : kind == "i" ? "int" : "uint";
    const std::string name(row.name);
    const bool isDepth = base::hasDepth(row.format);
    const std::string body =
        isDepth ? "void main() { gl_FragDepth = uValues[int(gl_FragCoord.x)]; }\n"
                : "out " + kind +
                      "vec4 fColor;\nvoid main() {\n    int x = int(gl_FragCoord.x);\n    fColor = " + kind +
                      "vec4(uValues[x], uValues[(x + 16) % 64], uValues[(x + 32) % 64], uValues[(x + 48) % "
                      "64]);\n}\n";
    return "WindowSize 4 4\nTexture2D map 64 1 " + name +
           "\nVertex inline\n#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : "
           "-1., "
           "gl_VertexID == 2 ? 3. : -1., 0., 1.); }\nEndVertex\nFragment inline\n#version 330 "
           "core\nuniform " +
           number + " uValues[64];\n" + body + "EndFragment\nProgram Write uValues " + listOf(values) +
           "\nPass map\nState depth always\nVertices triangles 3\nEndPass\n";
}

/// The 64 values for a format: its ends, values beyond them, and random ones that no rounding of a float
/// moves to another step.
std::vector<double> valuesFor(const base::TexelFormatRow& row, double largest) {
    std::mt19937 random(static_cast<unsigned>(row.format) + 1);
    const bool isSigned = row.kind == TexelClass::signedNormalized || row.kind == TexelClass::integer;
    std::vector<double> values;
    if (base::isInteger(row.format)) {
        values = {0, 1, largest, largest - 1, isSigned ? -largest - 1 : 2, isSigned ? -largest : 3};
        while (values.size() < kRowTexels)
            values.push_back(
                std::floor(std::uniform_real_distribution<>(isSigned ? -largest : 0, largest)(random)));
        return values;
    }
    values = {0, 1, .5, .25};
    if (!base::hasDepth(row.format)) values.insert(values.end(), {-2, 3, -.25});
    while (values.size() < kRowTexels) {
        const auto value = static_cast<double>(
            static_cast<float>(std::uniform_real_distribution<>(isSigned ? -1 : 0, 1)(random)));
        const double steps = std::abs(value) * largest;
        if (std::abs(steps - std::floor(steps) - .5) > .02) values.push_back(value);
    }
    return values;
}

/// All values of a small float without sign, in order; `bits` of them are the mantissa.
std::vector<double> smallFloats(int bits) {
    std::vector<double> all;
    const int steps = 1 << bits;
    for (int i = 0; i < 31 * steps; ++i) {
        const int exponent = i / steps, mantissa = i % steps;
        all.push_back(exponent == 0 ? std::ldexp(mantissa, -14 - bits)
                                    : std::ldexp(mantissa + steps, exponent - 15 - bits));
    }
    return all;
}

/// The largest of the values that is not above this one. llvmpipe cuts floats toward zero where the format
/// has fewer bits; OpenGL 4.6, 2.3.4, leaves the rounding open.
double nextBelow(const std::vector<double>& all, double value) {
    const auto above = std::upper_bound(all.begin(), all.end(), value);
    return above == all.begin() ? all.front() : *(above - 1);
}
double nextAbove(const std::vector<double>& all, double value) {
    const auto above = std::lower_bound(all.begin(), all.end(), value);
    return above == all.end() ? all.back() : *above;
}

/// The values of a format with small floats; empty for others.
const std::vector<double>& smallFloatsOf(const base::TexelFormatRow& row, std::size_t component) {
    static const std::vector<double> kHalf = smallFloats(10), kEleven = smallFloats(6), kTen = smallFloats(5),
                                     kNone;
    if (row.name == "r11f_g11f_b10f") return component < 2 ? kEleven : kTen;
    return row.name.ends_with("16f") ? kHalf : kNone;
}

/// The integer for 1 in a normalized format; 0 for formats of 32-bit floats.
double stepsOf(const base::TexelFormatRow& row, std::size_t component) {
    const std::string_view name = row.name;
    if (name.ends_with("32f") || name == "depth32f_stencil8") return 0;
    if (name == "rgb10_a2") return component < 3 ? 1023 : 3;
    if (name.starts_with("depth24")) return 16'777'215;
    const bool isWide = name.find("16") != std::string_view::npos;
    if (row.kind == TexelClass::signedNormalized) return isWide ? 32767 : 127;
    return isWide ? 65535 : 255;
}

/// What may remain of a value in a format, as a picture or a shader reads it: the format's values next to it,
/// of which OpenGL only prefers the nearest (4.6, 2.3.5.2). They are equal for a value that the format has.
std::array<double, 2> neighbours(const base::TexelFormatRow& row, std::size_t component, double value) {
    const double largest = stepsOf(row, component);
    if (largest == 0) return {value, value};
    const double lowest = row.kind == TexelClass::signedNormalized ? -1 : 0;
    const double steps = std::clamp(value, lowest, 1.) * largest;
    const double nearest = std::round(steps);
    if (std::abs(steps - nearest) < largest * 1e-7) return {nearest / largest, nearest / largest};
    return {std::floor(steps) / largest, std::ceil(steps) / largest};
}

double srgb(double linear) {
    const double c = std::clamp(linear, 0., 1.);
    return c <= .0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - .055;
}

TEST(ModernFormats, HoldTheExactQuantisationOfWhatIsWritten) {
    std::size_t tested = 0;
    for (const base::TexelFormatRow& row : base::texelFormats()) {
        if (base::isInteger(row.format)) continue;
        SCOPED_TRACE(std::string(row.name));
        const bool isFloat = base::isFloat(row.format);
        const bool isWide = row.name.find("16") != std::string_view::npos;
        const double largest = row.name.starts_with("depth24")            ? 16'777'215
                               : row.kind == TexelClass::signedNormalized ? (isWide ? 32767 : 127)
                               : row.name == "rgb10_a2"                   ? 1023
                               : isWide                                   ? 65535
                                                                          : 255;
        std::vector<double> values = valuesFor(row, isFloat ? 1e9 : largest);
        if (isFloat)
            for (std::size_t i = 8; i < values.size(); i += 3) values[i] *= 1000;
        for (double& each : values) each = static_cast<double>(static_cast<float>(each));
        RenderOptions options;
        options.wantedObjects = {"map"};
        const SceneFolder folder(writeScene(row, values));
        render::Stats stats;
        auto loaded = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        const bool isDrawn = loaded && loaded->draw(0, stats);
        if (!isDrawn) {  // the driver cannot draw into it, and the message says so
            EXPECT_TRUE(has(loaded.diagnostics, "gpu-E05")) << text(loaded.diagnostics);
            continue;
        }
        const auto& textures = loaded->scene().textures;
        std::size_t map = 0;
        while (textures[scene::TextureIndex(map)].name != "map") ++map;
        const auto found = loaded->textureImage({.texture = scene::TextureIndex(map)});
        ASSERT_TRUE(found) << text(found.diagnostics);
        ++tested;
        const auto components = static_cast<std::size_t>(found->components);
        const std::size_t given = base::hasDepth(row.format) ? 1 : row.components;
        for (int x = 0; x < kRowTexels; ++x)
            for (std::size_t c = 0; c < given; ++c) {
                const std::size_t at = static_cast<std::size_t>(x) * components + c;
                const double value =
                    values[base::hasDepth(row.format) ? static_cast<std::size_t>(x) : indexOf(x, c)];
                if (row.name == "srgb8_alpha8" && c < 3) {
                    // OpenGL 4.6, 17.3.7: an error below .6 of a step.
                    EXPECT_LE(std::abs(std::to_integer<int>(found->data[at]) - srgb(value) * 255), .6)
                        << value;
                    continue;
                }
                if (const auto& all = smallFloatsOf(row, c); !all.empty()) {
                    const double size = row.name == "r11f_g11f_b10f" ? std::max(value, 0.) : std::abs(value);
                    const float read = floatAt(*found, at);
                    EXPECT_TRUE(std::abs(read) == nextBelow(all, size) ||
                                std::abs(read) == nextAbove(all, size))
                        << value << " became " << read;
                    EXPECT_GE(read * value, 0);
                    continue;
                }
                const auto [below, above] = neighbours(row, c, value);
                switch (found->type) {
                    case image::Component::u8: {
                        // What was stored is read as a byte, for which it is rounded to nearest.
                        const int stored = std::to_integer<int>(found->data[at]);
                        const bool isRead =
                            stored == std::lround(below * 255) || stored == std::lround(above * 255);
                        EXPECT_TRUE(isRead) << value << " became " << stored;
                        break;
                    }
                    case image::Component::u16: {
                        std::uint16_t stored = 0;
                        std::memcpy(&stored, found->data.data() + at * 2, 2);
                        if (row.name == "rgb10_a2" && c < 3) {
                            // OpenGL 4.6, 2.3.5: one of the two nearest.
                            const double steps = std::clamp(value, 0., 1.) * 1023;
                            EXPECT_LT(std::abs(stored / 65535. * 1023 - steps), 1) << value;
                            break;
                        }
                        EXPECT_TRUE(stored == std::lround(below * 65535) ||
                                    stored == std::lround(above * 65535))
                            << value << " became " << stored;
                        break;
                    }
                    case image::Component::f32:
                        if (row.name.starts_with("depth24")) {  // one of the two nearest, again
                            EXPECT_LT(std::abs(floatAt(*found, at) - std::clamp(value, 0., 1.)) * 16'777'215,
                                      1.01)
                                << value;
                            break;
                        }
                        EXPECT_TRUE(floatAt(*found, at) == static_cast<float>(below) ||
                                    floatAt(*found, at) == static_cast<float>(above))
                            << value << " became " << floatAt(*found, at);
                        break;
                }
            }
    }
    EXPECT_GE(tested, 20U);
}

TEST(ModernFormats, HoldIntegersBitForBit) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    RenderOptions everything;
    everything.skip = false;
    for (const base::TexelFormatRow& row : base::texelFormats()) {
        if (!base::isInteger(row.format)) continue;
        SCOPED_TRACE(std::string(row.name));
        const bool isSigned = row.kind == TexelClass::integer;
        const int bits = row.bytes * 8 / row.components;
        // Lists are read as doubles and given to the shader as integers.
        const std::vector<double> values = valuesFor(row, std::ldexp(1, isSigned ? bits - 1 : bits) - 1);
        const std::string kind = isSigned ? "i" : "u", type = isSigned ? "int" : "uint";
        TextScene scene(writeScene(row, values) + "Buffer Found " + type + " 256\nCompute inline\n" +
                            "#version 430 core\nlayout(local_size_x = 64) in;\nuniform " + kind +
                            "sampler2D uMap;\nlayout(std430) writeonly buffer Found { " + type +
                            " found[]; };\nvoid main() {\n    int x = int(gl_GlobalInvocationID.x);\n    " +
                            kind +
                            "vec4 v = texelFetch(uMap, ivec2(x, 0), 0);\n"
                            "    for (int c = 0; c < 4; ++c) found[x * 4 + c] = v[c];\n}\nEndCompute\n"
                            "Program Read uMap map\nDispatch Read over 64\n",
                        {}, everything);
        scene.draw();
        const std::vector<double> found = scene.buffer("Found", 256);
        for (int x = 0; x < kRowTexels; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                const double exact = c < row.components ? values[indexOf(x, c)] : c == 3 ? 1 : 0;
                EXPECT_EQ(found[static_cast<std::size_t>(x) * 4 + c], exact) << "texel " << x << "." << c;
            }
    }
}

// ---- State.

/// A triangle that covers the target, whose depth is `depth` (in window coordinates x, y, 0..8).
std::string coveringScene(const std::string& target, const std::string& state, const std::string& depth) {
    return "WindowSize 8 8\nTexture2D map 8 8 " + target +
           "\nVertex inline\n#version 330 core\nflat out vec3 vCorner;\nvoid main() {\n"
           "    vec2 at = vec2(gl_VertexID == 1 ? 16. : 0., gl_VertexID == 2 ? 16. : 0.);\n"
           "    float x = at.x, y = at.y;\n    vCorner = vec3(equal(ivec3(gl_VertexID), ivec3(0, 1, 2)));\n"
           "    gl_Position = vec4(at / 4. - 1., 2. * (" +
           depth +
           ") - 1., 1.);\n}\nEndVertex\nFragment inline\n#version 330 core\nflat in vec3 vCorner;\n"
           "uniform float uAlpha;\nout vec4 fColor;\nvoid main() { fColor = vec4(vCorner, uAlpha); "
           "}\nEndFragment\n"
           "Program Cover uAlpha 1.\nPass map clear {0 0 0 0}\nState " +
           state + "\nVertices triangles 3\nEndPass\n";
}

image::Image mapOf(const std::string& scene) {
    RenderOptions options;
    options.wantedObjects = {"map"};
    TextScene drawn(scene, {}, options);
    drawn.draw();
    return drawn.texture("map");
}

TEST(ModernState, OffsetsDepthByItsSlopeAndItsUnits) {
    // OpenGL 4.6, 14.6.5: factor times the largest slope, plus units times the least resolvable difference,
    // which depends on the driver, and for floats on the exponent of the depth.
    const auto depthAt = [](const std::string& format, const std::string& state, const std::string& depth,
                            int x, int y) {
        const image::Image map = mapOf(coveringScene(format, state, depth));
        return static_cast<double>(floatAt(map, static_cast<std::size_t>((7 - y) * 8 + x)));
    };
    const std::string slanted = "(.25 + x / 64. + y / 128.)";
    for (const char* format : {"depth24", "depth32f"})
        for (const int x : {0, 5}) {
            const double plain = .25 + (x + .5) / 64 + 2.5 / 128;
            EXPECT_NEAR(depthAt(format, "offset 0 0", slanted, x, 2), plain, 1e-6) << format;
            EXPECT_NEAR(depthAt(format, "offset 2 0", slanted, x, 2), plain + 2 / 64., 1e-6) << format;
            EXPECT_NEAR(depthAt(format, "offset -3 0", slanted, x, 2), plain - 3 / 64., 1e-6) << format;
        }
    // A unit is the driver's to choose. It is at least the difference of two depths, and not much more.
    constexpr double kStep = 1 / 16'777'215., kMost = 8;
    const double flat = depthAt("depth24", "offset 0 0", ".5", 1, 1);
    const double unit = (depthAt("depth24", "offset 0 400", ".5", 1, 1) - flat) / 400 / kStep;
    EXPECT_GE(unit, .99);
    EXPECT_LE(unit, kMost);
    EXPECT_NEAR((depthAt("depth24", "offset 0 -400", ".5", 1, 1) - flat) / 400 / kStep, -unit, .01);
    for (const double depth : {.5, .125}) {
        const double step = depth * 0x1p-23;  // between two floats
        const std::string at = std::to_string(depth);
        const double floatUnit = (depthAt("depth32f", "offset 0 400", at, 1, 1) - depth) / 400;
        EXPECT_GE(floatUnit, .99 * step) << depth;
        EXPECT_LE(floatUnit, kMost * kStep) << depth;
    }
}

TEST(ModernState, TakesFlatValuesFromTheProvokingVertex) {
    const auto cornerOf = [](const std::string& state) {
        const image::Image map = mapOf(coveringScene("rgba8", state, ".5"));
        for (int corner = 0; corner < 3; ++corner)
            if (byteAt(map, 3, 3, corner) == 255) return corner;
        return -1;
    };
    EXPECT_EQ(cornerOf("provoking first"), 0);
    EXPECT_EQ(cornerOf("provoking last"), 2);
    EXPECT_EQ(cornerOf("default"), 2);
}

TEST(ModernState, CoversAsManySamplesAsAlphaSays) {
    const auto redAt = [](double alpha, const std::string& state) {
        std::string scene = coveringScene("rgba8 samples 4", state, ".5");
        scene.replace(scene.find("uAlpha 1."), 9, "uAlpha " + std::to_string(alpha));
        // A program without a vertex stage stands before the others.
        scene.insert(
            scene.find("Vertex inline"),
            "Fragment inline\n#version 330 core\nin vec2 vST;\nuniform sampler2D uMap;\nout vec4 fColor;\n"
            "void main() { fColor = vec4(texture(uMap, vST).b); }\nEndFragment\nProgram Show uMap map\n");
        TextScene drawn(scene + "Fill window with Show\n");
        const image::Image picture = drawn.draw();
        double sum = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) sum += byteAt(picture, x, y);
        return sum / 64 / 255;
    };
    double before = 0;
    std::set<double> levels;
    for (int i = 0; i <= 16; ++i) {
        const double alpha = i / 16., red = redAt(alpha, "alphatocoverage on");
        EXPECT_NEAR(red, alpha, .26) << "to one of four samples";
        EXPECT_GE(red, before);
        levels.insert(before = red);
    }
    EXPECT_EQ(redAt(0, "alphatocoverage on"), 0);
    EXPECT_EQ(redAt(1, "alphatocoverage on"), 1);
    EXPECT_GE(levels.size(), 4U);
    EXPECT_EQ(redAt(.5, "alphatocoverage off"), 1);
}

}  // namespace
}  // namespace glibra::test
