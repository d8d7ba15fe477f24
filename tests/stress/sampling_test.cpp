// Textures where filters, wrapping and faces meet (exercises' accuracy table 36, 47; NM25, NM28, NM29, NM43):
// texel centres, borders, ties between the faces of a cube, and the precision of target formats.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "image/png/png_writer.h"
#include "support.h"

namespace glibra::stress {
namespace {

/// A raw float texture with these red values, s fastest.
std::string rawTexture(std::uint32_t width, std::uint32_t height, const std::vector<float>& red) {
    std::vector<float> texels;
    for (const float value : red) texels.insert(texels.end(), {value, 0, 0, 1});
    std::string bytes(8 + texels.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), &width, 4);
    std::memcpy(bytes.data() + 4, &height, 4);
    std::memcpy(bytes.data() + 8, texels.data(), texels.size() * sizeof(float));
    return bytes;
}

/// Values that differ between neighbours.
std::vector<float> scattered(int count) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) values.push_back(static_cast<float>((i * 37) % 101) / 100);
    return values;
}

TEST(TexelCentres, GiveTheTexelItselfWhateverTheSize) {
    for (const auto& [width, height] : {std::pair{7, 5}, {16, 16}, {33, 3}, {100, 1}, {1, 1}}) {
        const std::vector<float> red = scattered(width * height);
        Files files = shaded(
            "vec3(texture(uTex, gl_FragCoord.xy / vec2(textureSize(uTex, 0))).r, "
            "texelFetch(uTex, ivec2(gl_FragCoord.xy), 0).r, 0.)",
            "uniform sampler2D uTex;\n");
        files["t.tex"] =
            rawTexture(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), red);
        const FloatPicture picture =
            draw(fmt::format("WindowSize {} {}\n", width, height) + kFrontView +
                     "Texture2D 6 t.tex\nVertex v.vert\nFragment f.frag\nProgram P uTex 6\nQuadXY 0 1000\n",
                 files);
        ASSERT_EQ(picture.width, width);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float wanted =
                    red[static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)];
                EXPECT_EQ(picture.at(x, y)[1], wanted) << width << ": " << x << " " << y;
                // A weight is the fraction of a coordinate up to `width`.
                EXPECT_NEAR(picture.at(x, y)[0], wanted, 1e-7F * static_cast<float>(width)) << x << " " << y;
            }
    }
}

TEST(TextureBorders, RepeatOrClampAsTheSceneSays) {
    // Coordinates from -2 to 3 in steps of 1/8 texel. Linear filtering follows the definition, in double.
    constexpr int kTexels = 8, kSteps = 5 * kTexels * 8;
    const std::vector<float> red = scattered(kTexels);
    Files files = shaded("vec3(texture(uTex, vec2((gl_FragCoord.x - .5) / 64. - 2., .5)).r)",
                         "uniform sampler2D uTex;\n");
    files["t.tex"] = rawTexture(kTexels, 1, red);
    for (const bool isClamped : {false, true}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize {} 1\n", kSteps) + kFrontView +
                     (isClamped ? "Clamp on\n" : "Clamp off\n") +
                     "Texture2D 6 t.tex\nVertex v.vert\nFragment f.frag\nProgram P uTex 6\nQuadXY 0 10000\n",
                 files);
        ASSERT_EQ(picture.width, kSteps);
        const auto texel = [&](int i) {
            const int inside =
                isClamped ? std::clamp(i, 0, kTexels - 1) : ((i % kTexels) + kTexels) % kTexels;
            return static_cast<double>(red[static_cast<std::size_t>(inside)]);
        };
        for (int x = 0; x < kSteps; ++x) {
            const double place = (x / 64. - 2) * kTexels - .5;
            const int low = static_cast<int>(std::floor(place));
            const double wanted = std::lerp(texel(low), texel(low + 1), place - low);
            EXPECT_NEAR(static_cast<double>(picture.at(x, 0)[0]), wanted, 2e-6) << isClamped << " " << x;
        }
    }
}

TEST(RenderedTextures, KeepWhatTheirFormatCan) {
    // Values from -1 to 3. A byte keeps multiples of 1/255 in 0..1, a half float 11 bits, a float everything.
    const std::string values = "(floor(gl_FragCoord.x) * .01568603515625 - 1.)";
    Files files = shaded("vec3(" + values + ")");
    files["show.frag"] =
        "#version 330 core\nuniform sampler2D uTex;\nout vec4 fColor;\n"
        "void main() { fColor = vec4(texelFetch(uTex, ivec2(gl_FragCoord.xy), 0).rgb, 1.); }\n";
    for (const std::string format : {"RGBA8", "RGBA16F", "RGBA32F"}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize 256 1\n{}Texture2D 6 256 1 {}\nRenderToTexture 6\n{}QuadXY 0 10000\n"
                             "RenderToTexture\nFragment show.frag\nProgram Show uTex 6\nQuadXY 0 10000\n",
                             kFrontView, format, kProgram),
                 files);
        ASSERT_EQ(picture.width, 256);
        int limited = 0;
        for (int x = 0; x < 256; ++x) {
            const double value = x * 257. / 16384 - 1, seen = static_cast<double>(picture.at(x, 0)[0]);
            const double inside = std::clamp(value, 0., 1.);
            if (format == "RGBA8") {
                // A value halfway between two bytes may become either.
                EXPECT_NEAR(seen * 255, inside * 255, .5001) << x;
                EXPECT_NEAR(seen * 255, std::round(seen * 255), 1e-4) << x;
                if (inside != value) ++limited;
            } else if (format == "RGBA16F") {
                EXPECT_NEAR(seen, value, std::abs(value) * 0x1p-10) << x;
            } else {
                EXPECT_EQ(seen, value) << x;
            }
        }
        EXPECT_EQ(limited, format == "RGBA8" ? 64 + 128 : 0) << "of 64 below 0 and 128 above 1";
    }
}

using Face = std::array<glm::dvec3, 3>;  ///< direction, and those of rising s and t (OpenGL 4.1, table 3.20)
const std::array<Face, 6> kFaces{{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}},
                                  {{{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
                                  {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}},
                                  {{{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}},
                                  {{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}},
                                  {{{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}}};
constexpr int kFaceSide = 16;

/// The six pictures of a cube with 16 bits per component, coloured by the direction of each texel.
Files cubeFiles(glm::dvec3 (*color)(int face, const glm::dvec3& direction)) {
    Files files;
    for (std::size_t face = 0; face < 6; ++face) {
        image::Image picture{kFaceSide, kFaceSide, 3, image::Component::u16, {}};
        for (int row = 0; row < kFaceSide; ++row)
            for (int column = 0; column < kFaceSide; ++column) {
                const glm::dvec3 direction = kFaces[face][0] +
                                             (2 * column + 1. - kFaceSide) / kFaceSide * kFaces[face][1] +
                                             (2 * row + 1. - kFaceSide) / kFaceSide * kFaces[face][2];
                const glm::dvec3 rgb = color(static_cast<int>(face), glm::normalize(direction));
                for (int i = 0; i < 3; ++i) {
                    const auto level = static_cast<std::uint16_t>(std::lround(rgb[i] * 65535));
                    const auto* bytes = reinterpret_cast<const std::byte*>(&level);
                    picture.data.insert(picture.data.end(), bytes, bytes + 2);
                }
            }
        const std::vector<std::byte> png = image::encodePng(picture);
        files[fmt::format("{}.png", face)] =
            std::string(reinterpret_cast<const char*>(png.data()), png.size());
    }
    return files;
}

/// The colours of the cube in these directions, in their order.
std::vector<std::array<float, 3>> looked(Files files, const std::vector<glm::dvec3>& directions) {
    const auto count = static_cast<std::uint32_t>(directions.size());
    std::vector<float> texels;
    for (const glm::dvec3& each : directions)
        texels.insert(texels.end(), {static_cast<float>(each.x), static_cast<float>(each.y),
                                     static_cast<float>(each.z), 1});
    std::string bytes(8 + texels.size() * sizeof(float), '\0');
    const std::uint32_t height = 1;
    std::memcpy(bytes.data(), &count, 4);
    std::memcpy(bytes.data() + 4, &height, 4);
    std::memcpy(bytes.data() + 8, texels.data(), texels.size() * sizeof(float));
    files["directions.tex"] = bytes;
    const Files shaders =
        shaded("textureLod(uSky, texelFetch(uDirections, ivec2(int(gl_FragCoord.x), 0), 0).xyz, 0.).rgb",
               "uniform samplerCube uSky;\nuniform sampler2D uDirections;\n");
    files.insert(shaders.begin(), shaders.end());
    const FloatPicture picture =
        draw(fmt::format("WindowSize {} 1\n", count) + kFrontView +
                 "CubeMap 6 0.png 1.png 2.png 3.png 4.png 5.png\nTexture2D 7 directions.tex\n"
                 "Vertex v.vert\nFragment f.frag\nProgram P uSky 6 uDirections 7\nQuadXY 0 100000\n",
             files);
    std::vector<std::array<float, 3>> seen;
    seen.reserve(directions.size());
    for (int x = 0; x < picture.width; ++x) seen.push_back(picture.at(x, 0));
    return seen;
}

TEST(CubeMaps, ShowTheFaceOfTheLargestComponentAndOnlyTiedOnesAtTies) {
    const Files files = cubeFiles([](int face, const glm::dvec3&) { return glm::dvec3(face / 8., 0, 0); });
    std::vector<glm::dvec3> directions;
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z)
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 4) directions.emplace_back(x, y, z);
    const auto seen = looked(files, directions);
    ASSERT_EQ(seen.size(), directions.size());
    int ties = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        double low = 9, high = -1;
        for (std::size_t face = 0; face < 6; ++face) {
            if (glm::dot(kFaces[face][0], directions[i]) < 4) continue;
            low = std::min(low, static_cast<double>(face) / 8);
            high = std::max(high, static_cast<double>(face) / 8);
        }
        ties += low < high ? 1 : 0;
        EXPECT_GE(seen[i][0], low - 1e-4)
            << directions[i].x << " " << directions[i].y << " " << directions[i].z;
        EXPECT_LE(seen[i][0], high + 1e-4)
            << directions[i].x << " " << directions[i].y << " " << directions[i].z;
    }
    EXPECT_EQ(ties, 8 + 12 * 7) << "corners and edges of the grid";
}

TEST(CubeMaps, HaveNoSeamsBetweenTheirFaces) {
    // The colour is a smooth function of the direction. Filtered across an edge, it is as exact as inside a
    // face. Clamped at the faces, it would be off by half a texel, which is 1/16.
    const Files files = cubeFiles([](int, const glm::dvec3& direction) { return (direction + 1.) / 2.; });
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 720; ++i) {
        const double a = i * .5 * std::asin(1.) / 90;
        directions.emplace_back(std::cos(a), std::sin(a), .3);
        directions.emplace_back(.2, std::cos(a), std::sin(a));
        directions.emplace_back(std::sin(a), -.4, std::cos(a));
    }
    const auto seen = looked(files, directions);
    ASSERT_EQ(seen.size(), directions.size());
    double worst = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const glm::dvec3 wanted = (glm::normalize(directions[i]) + 1.) / 2.;
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst,
                             std::abs(static_cast<double>(seen[i][static_cast<std::size_t>(c)]) - wanted[c]));
    }
    EXPECT_LT(worst, .01);
    EXPECT_GT(worst, 1e-5) << "linear filtering of a curved function is not exact";
}

}  // namespace
}  // namespace glibra::stress
