// What a program writes into the textures and buffers of a loaded scene.

#include <fmt/format.h>
#include <glibra/glibra.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "support.h"

namespace glibra {
namespace {

namespace fs = std::filesystem;

using tests::firstPixel;
using tests::isIn;
using tests::opened;

/// A scene that shows what GLSL makes of `declarations` in each pixel.
std::string showing(const std::string& statements, const std::string& declarations,
                    const std::string& color) {
    return fmt::format(
        "WindowSize 4 3\n{}\nFragment inline\n#version 430\n{}\nout vec4 fColor;\n"
        "void main() {{ ivec2 at = ivec2(gl_FragCoord.xy); fColor = {}; }}\nEndFragment\nProgram Show\n"
        "Fill window with Show\n",
        statements, declarations, color);
}

std::vector<float> floatsOf(const Picture& picture) {
    std::vector<float> all(picture.data.size() / sizeof(float));
    std::memcpy(all.data(), picture.data.data(), picture.data.size());
    return all;
}

/// 0, 1, 2 ... times a factor.
template <class Number>
std::vector<Number> ramp(std::size_t count, double factor) {
    std::vector<Number> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<Number>(static_cast<double>(i) * factor);
    return all;
}

std::string bytesOf(const std::vector<float>& texels, std::initializer_list<std::int32_t> sizes) {
    std::string file;
    for (const std::int32_t each : sizes) file.append(reinterpret_cast<const char*>(&each), sizeof each);
    file.append(reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof(float));
    return file;
}

const DrawOptions kFloats{.floatPixels = true};
constexpr const char* kVolume = "uniform sampler3D volume;";
constexpr const char* kTexel = "texelFetch(volume, ivec3(at, 1), 0)";

TEST(LibraryWrite, GivesForEachTimeStepThePictureOfAFileWithTheSameTexels) {
    Renderer renderer = opened();
    Result<Scene> scene =
        renderer.loadText(showing("Texture3D volume 4 3 2 rgba32f", kVolume, kTexel), "volume.glib");
    ASSERT_TRUE(scene) << scene.message();
    for (int step = 0; step < 20; ++step) {
        const std::vector<float> texels = ramp<float>(4 * 3 * 2 * 4, .01 * (step + 1));
        const Result<void> done = scene->write("volume", texels);
        ASSERT_TRUE(done) << done.message();
        const Result<Picture> picture = scene->draw(kFloats);
        ASSERT_TRUE(picture) << picture.message();
        EXPECT_TRUE(picture.diagnostics().empty()) << picture.message();
        Result<Scene> same = renderer.loadText(showing("Texture3D volume volume.tex", kVolume, kTexel),
                                               "file.glib", {{"volume.tex", bytesOf(texels, {4, 3, 2})}});
        ASSERT_TRUE(same) << same.message();
        const Result<Picture> expected = same->draw(kFloats);
        ASSERT_TRUE(expected) << expected.message();
        EXPECT_TRUE(compare(*picture, *expected, {.exact = true}).same) << step;
    }
}

TEST(LibraryWrite, TakesTheRowsOfPictureFilesAndGivesThemBack) {
    Renderer renderer = opened();
    const Picture photo{4, 3, 4, false, false, 8, [] {
                            std::vector<std::byte> all;
                            for (int i = 0; i < 48; ++i) all.push_back(static_cast<std::byte>(5 * i));
                            return all;
                        }()};
    const fs::path file = fs::temp_directory_path() / fmt::format("glibra_write_{}.png", ::getpid());
    ASSERT_TRUE(photo.save(file));
    const std::string show = "texelFetch(photo, at, 0)";
    for (const std::string& declared :
         {std::string("4 3 rgba8"), fmt::format("\"{}\"", file.generic_string())}) {
        Result<Scene> scene = renderer.loadText(
            showing("Texture2D photo " + declared, "uniform sampler2D photo;", show), "photo.glib");
        ASSERT_TRUE(scene) << scene.message();
        Picture turned = photo;
        std::ranges::reverse(turned.data);
        ASSERT_TRUE(scene->write("photo", turned.data));
        ASSERT_TRUE(scene->write("photo", photo.data));
        const Result<Picture> picture = scene->draw({.alpha = true});
        ASSERT_TRUE(picture) << picture.message();
        EXPECT_TRUE(compare(*picture, photo, {.exact = true}).same) << declared;
        EXPECT_TRUE(compare(*scene->target("photo"), photo, {.exact = true}).same) << declared;
    }
    fs::remove(file);
}

TEST(LibraryWrite, LeavesAnotherTextureOfTheSameFileAsItIs) {
    Renderer renderer = opened();
    const std::map<std::string, std::string> files{
        {"a.tex", bytesOf(std::vector<float>(4 * 3 * 4, .25F), {4, 3})}};
    Result<Scene> scene = renderer.loadText(
        showing("Texture2D one a.tex\nTexture2D other a.tex", "uniform sampler2D one, other;",
                "vec4(texelFetch(one, at, 0).r, texelFetch(other, at, 0).r, 0, 1)"),
        "two.glib", files);
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->draw());
    ASSERT_TRUE(scene->write("one", std::vector<float>(4 * 3 * 4, .5F)));
    const Result<Picture> picture = scene->draw(kFloats);
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(floatsOf(*picture)[0], .5F);
    EXPECT_EQ(floatsOf(*picture)[1], .25F);
    ASSERT_TRUE(scene->reload());
    EXPECT_EQ(floatsOf(*scene->draw(kFloats))[0], .25F);
}

template <class Number>
void expectKept(Renderer& renderer, const char* format, const char* sampler, std::size_t components) {
    Result<Scene> scene =
        renderer.loadText(showing(fmt::format("Texture2D made 3 2 {}", format),
                                  fmt::format("uniform {} made;", sampler), "vec4(texelFetch(made, at, 0))"),
                          "made.glib");
    ASSERT_TRUE(scene) << scene.message();
    const std::vector<Number> numbers =
        ramp<Number>(3 * 2 * components, std::is_same_v<Number, float> ? .125 : 1);
    const Result<void> done = scene->write("made", numbers);
    ASSERT_TRUE(done) << format << done.message();
    ASSERT_TRUE(scene->draw());
    const Result<Picture> kept = scene->target("made");
    ASSERT_TRUE(kept) << format << kept.message();
    ASSERT_EQ(kept->data.size(), numbers.size() * sizeof(Number)) << format;
    EXPECT_EQ(std::memcmp(kept->data.data(), numbers.data(), kept->data.size()), 0) << format;
    const Result<void> wrong = scene->write("made", ramp<double>(3 * 2 * components, 1));
    EXPECT_PRED2(isIn, wrong.message(), "library-E03") << format;
    EXPECT_PRED2(isIn, wrong.message(),
                 fmt::format("({}) takes {} of shape (2, 3", format, numberWord<Number>()));
    EXPECT_PRED2(isIn, wrong.message(), fmt::format("found {} x float64", 6 * components));
}

TEST(LibraryWrite, TakesTheNumbersOfTheFormatAndNoOthers) {
    Renderer renderer = opened();
    expectKept<std::uint8_t>(renderer, "r8", "sampler2D", 1);
    expectKept<std::uint8_t>(renderer, "rg8", "sampler2D", 2);
    expectKept<std::uint16_t>(renderer, "rgba16", "sampler2D", 4);
    expectKept<float>(renderer, "rg16f", "sampler2D", 2);
    expectKept<float>(renderer, "r32f", "sampler2D", 1);
    expectKept<float>(renderer, "depth32f", "sampler2D", 1);
    expectKept<std::int8_t>(renderer, "rgba8i", "isampler2D", 4);
    expectKept<std::int16_t>(renderer, "r16i", "isampler2D", 1);
    expectKept<std::int32_t>(renderer, "rg32i", "isampler2D", 2);
    expectKept<std::uint32_t>(renderer, "r32ui", "usampler2D", 1);
}

/// Each layer or face, as target() gives it, is that part of what was written.
TEST(LibraryWrite, HasTheLayersAndFacesOneAfterTheOther) {
    Renderer renderer = opened();
    struct Case {
        const char *declared, *sampler, *read, *part;
        std::size_t layers, height, width;
    };
    for (const Case& each :
         {Case{"Texture1D made 4", "sampler1D", "at.x", "", 1, 1, 4},
          {"Texture1DArray made 4 3", "sampler1DArray", "at", ".layer", 3, 1, 4},
          {"Texture2DArray made 4 3 2", "sampler2DArray", "ivec3(at, 0)", ".layer", 2, 3, 4},
          {"CubeMap made 4", "samplerCube", "", ".face", 6, 4, 4},
          {"TextureRect made 4 3", "sampler2DRect", "at", "", 1, 3, 4}}) {
        const bool isRect = std::string_view(each.sampler) == "sampler2DRect";
        const std::string fetched =
            *each.read == 0 ? std::string("texture(made, vec3(1, at))")
                            : fmt::format("texelFetch(made, {}{})", each.read, isRect ? "" : ", 0");
        Result<Scene> scene = renderer.loadText(
            showing(fmt::format("{} rg16ui", each.declared), fmt::format("uniform u{} made;", each.sampler),
                    fmt::format("vec4({})", fetched)),
            "made.glib");
        ASSERT_TRUE(scene) << each.declared << scene.message();
        const auto numbers = ramp<std::uint16_t>(each.layers * each.height * each.width * 2, 1);
        const Result<void> done = scene->write("made", numbers);
        ASSERT_TRUE(done) << done.message();
        ASSERT_TRUE(scene->draw());
        for (std::size_t i = 0; i < each.layers; ++i) {
            const Result<Picture> part =
                scene->target(*each.part == 0 ? "made" : fmt::format("made{}({})", each.part, i));
            ASSERT_TRUE(part) << part.message();
            const std::size_t size = each.height * each.width * 4;
            ASSERT_EQ(part->data.size(), size) << each.declared;
            EXPECT_EQ(std::memcmp(part->data.data(),
                                  reinterpret_cast<const std::byte*>(numbers.data()) + i * size, size),
                      0)
                << each.declared << i;
        }
    }
}

TEST(LibraryWrite, KeepsNumbersThatAreNone) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        showing("Texture2D field 2 1 r32f", "uniform sampler2D field;",
                "vec4(isnan(texelFetch(field, ivec2(0), 0).r), texelFetch(field, ivec2(1, 0), 0).r, 0, 1)"),
        "nan.glib");
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->write("field", std::array{std::numeric_limits<float>::quiet_NaN(), .5F}));
    const Result<Picture> picture = scene->draw(kFloats);
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(floatsOf(*picture)[0], 1);
    EXPECT_EQ(floatsOf(*picture)[1], .5F);
}

TEST(LibraryWrite, MakesTheMipmapsThatTheSceneAsksFor) {
    Renderer renderer = opened();
    Result<Scene> scene =
        renderer.loadText(showing("Texture2D field 4 4 r32f mipmap generate", "uniform sampler2D field;",
                                  "vec4(textureLod(field, vec2(.5), 2.))"),
                          "mipmaps.glib");
    ASSERT_TRUE(scene) << scene.message();
    for (const float value : {.25F, .75F}) {
        ASSERT_TRUE(scene->write("field", std::vector<float>(16, value)));
        EXPECT_EQ(floatsOf(*scene->draw(kFloats))[0], value);
    }
}

/// A scene whose compute shader copies numbers of `all` into `copied`.
std::string copying(const std::string& layout, const std::string& declarations, const std::string& block,
                    const std::string& statements, int copied) {
    return fmt::format(
        "WindowSize 4 3\nBuffer all 2\nBuffer copied double {4}\nCompute inline\n#version 430\n"
        "layout(local_size_x = 1) in;\n{1}\nlayout({0}) readonly buffer all {{ {2} }};\n"
        "layout(std430) buffer copied {{ double to[]; }};\nvoid main() {{ {3} }}\nEndCompute\nProgram Copy\n"
        "Dispatch Copy 1 1 1\nFragment inline\n#version 430\nlayout(std430) readonly buffer copied {{ double "
        "to[]; }};\nout vec4 fColor;\nvoid main() {{ fColor = vec4(to[0]); }}\nEndFragment\nProgram Show\n"
        "Fill window with Show\n",
        layout, declarations, block, statements, copied);
}

std::vector<double> copiedOf(Scene& scene) {
    if (const Result<Picture> picture = scene.draw(); !picture) ADD_FAILURE() << picture.message();
    const Result<BufferContent> content = scene.buffer("copied");
    if (!content) {
        ADD_FAILURE() << content.message();
        return {};
    }
    std::vector<double> all;
    for (std::uint64_t i = 0; i < content->elements; ++i)
        all.push_back(content->numbers(content->columns.front(), i).front());
    return all;
}

TEST(LibraryWrite, FillsEveryLayoutOfABuffer) {
    Renderer renderer = opened();
    struct Type {
        const char* name;
        int columns, rows;
        bool isDouble;
    };
    for (const char* layout : {"std430", "std140", "std430, row_major", "std140, row_major"})
        for (const Type& type : {Type{"vec3", 1, 3, false},
                                 {"mat2", 2, 2, false},
                                 {"mat3", 3, 3, false},
                                 {"mat2x3", 2, 3, false},
                                 {"mat4x3", 4, 3, false},
                                 {"dmat3", 3, 3, true},
                                 {"double", 1, 1, true},
                                 {"vec2", 1, 2, false}}) {
            const int numbers = type.columns * type.rows;
            std::string statements;
            for (int i = 0; i < 2; ++i) {
                statements += fmt::format("to[{}] = double(e[{}].a); ", i * (numbers + 2), i);
                for (int n = 0; n < numbers; ++n)
                    statements += fmt::format("to[{}] = double(e[{}].m{}{}); ", i * (numbers + 2) + 1 + n, i,
                                              type.columns == 1 ? "" : fmt::format("[{}]", n / type.rows),
                                              type.rows == 1 ? "" : fmt::format("[{}]", n % type.rows));
                statements += fmt::format("to[{}] = double(e[{}].z); ", i * (numbers + 2) + numbers + 1, i);
            }
            const std::string which = fmt::format("{} in {}", type.name, layout);
            Result<Scene> scene = renderer.loadText(
                copying(layout, fmt::format("struct E {{ float a; {} m; float z; }};", type.name), "E e[];",
                        statements, 2 * (numbers + 2)),
                "copy.glib");
            ASSERT_TRUE(scene) << which << scene.message();
            // A record of Python: the fields in another order, without padding.
            const std::size_t size = type.isDouble ? 8 : 4;
            DataView data;
            data.record = 8 + size * static_cast<std::size_t>(numbers);
            data.fields = {{"z", "float32", 0, 1},
                           {"m", type.isDouble ? "float64" : "float32", 4, static_cast<std::size_t>(numbers)},
                           {"a", "float32", data.record - 4, 1}};
            std::vector<std::byte> bytes;
            const auto add = [&](auto number) {
                const auto* begin = reinterpret_cast<const std::byte*>(&number);
                bytes.insert(bytes.end(), begin, begin + sizeof number);
            };
            std::vector<double> expected;
            for (int i = 0; i < 2; ++i) {
                add(100.F + static_cast<float>(i));
                for (int n = 0; n < numbers; ++n)
                    type.isDouble ? add(10. * i + n) : add(static_cast<float>(10 * i + n));
                add(-1.F - static_cast<float>(i));
                expected.push_back(-1 - i);
                for (int n = 0; n < numbers; ++n) expected.push_back(10 * i + n);
                expected.push_back(100 + i);
            }
            data.bytes = bytes;
            const Result<void> done = scene->write("all", data);
            ASSERT_TRUE(done) << which << done.message();
            EXPECT_EQ(copiedOf(*scene), expected) << which;
            data.fields.front().name = "y";
            EXPECT_PRED2(isIn, scene->write("all", data).message(), "library-E03") << which;
            if (type.isDouble) continue;
            // Numbers alone, and one element alone.
            std::vector<float> plain(expected.begin(), expected.end());
            for (float& each : plain) each *= 2;
            for (double& each : expected) each *= 2;
            ASSERT_TRUE(scene->write("all", plain)) << which;
            EXPECT_EQ(copiedOf(*scene), expected) << which;
            const std::size_t half = plain.size() / 2;
            ASSERT_TRUE(scene->write("all", std::vector<float>(half, 7), 1)) << which;
            std::fill(expected.begin() + static_cast<std::ptrdiff_t>(half), expected.end(), 7);
            EXPECT_EQ(copiedOf(*scene), expected) << which;
            const Result<void> late = scene->write("all", std::vector<float>(half, 7), 2);
            EXPECT_PRED2(isIn, late.message(), "has 2 elements of a (float32), m (") << which;
            EXPECT_PRED2(isIn, late.message(), "from element 2 on") << which;
            EXPECT_FALSE(scene->write("all", std::vector<float>(half, 7)));
            EXPECT_FALSE(scene->write("all", std::vector<float>(half - 1, 7), 1));
            EXPECT_FALSE(scene->write("all", std::vector<std::int32_t>(2 * half, 7)));
            EXPECT_EQ(copiedOf(*scene), expected) << which;
        }
}

TEST(LibraryWrite, TakesStructuresThatLieAsOnTheDevice) {
    struct alignas(16) Particle {
        std::array<float, 3> position;
        std::uint32_t kind;
    };
    Renderer renderer = opened();
    Result<Scene> scene =
        renderer.loadText(copying("std430", "struct E { vec3 p; uint kind; };", "uint count; E e[];",
                                  "to[0] = count; to[1] = e[0].p.z; to[2] = e[1].p.x; to[3] = e[1].kind;", 4),
                          "copy.glib");
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->write("all", std::array{Particle{{1, 2, 3}, 4}, Particle{{5, 6, 7}, 4000000000U}}));
    EXPECT_EQ(copiedOf(*scene), (std::vector<double>{0, 3, 5, 4e9}));
    DataView head;
    const std::uint32_t count = 9;
    head.bytes = std::as_bytes(std::span(&count, 1));
    head.type = "uint32";
    head.record = 4;
    head.isOfHead = true;
    ASSERT_TRUE(scene->write("all", head)) << scene->write("all", head).message();
    EXPECT_EQ(copiedOf(*scene), (std::vector<double>{9, 3, 5, 4e9}));
    EXPECT_PRED2(isIn, scene->write("all", std::vector<std::array<float, 3>>(1)).message(),
                 "in 16 bytes, found 1 x structures of 12 bytes");
}

/// A buffer of four numbers, which `blocks` change; the picture shows the first.
std::string simulating(const std::string& declared, const std::string& blocks) {
    return showing(
        declared +
            "\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
            "layout(std430) buffer v { float all[]; };\nvoid main() { all[gl_GlobalInvocationID.x] "
            "+= 1.; }\nEndCompute\nProgram Inc\n" +
            "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
            "layout(std430) buffer v { float all[]; };\nvoid main() { all[gl_GlobalInvocationID.x] "
            "= 5.; }\nEndCompute\nProgram Begin\n" +
            blocks,
        "layout(std430) readonly buffer v { float all[]; };", "vec4(all[0], all[3], 0, 1)");
}

float shownAt(Scene& scene, double time) {
    const Result<Picture> picture = scene.draw({.time = time, .floatPixels = true});
    if (!picture) ADD_FAILURE() << picture.message();
    return picture ? floatsOf(*picture).front() : -1;
}

TEST(LibraryWrite, IsWhatStepsGoOnFrom) {
    Renderer renderer = opened();
    for (const bool isDrawn : {false, true})
        for (const char* history : {"", " history"}) {
            Result<Scene> scene = renderer.loadText(simulating(fmt::format("Buffer v float 4 (1){}", history),
                                                               "Step 10\nDispatch Inc over v\nEndStep\n"),
                                                    "step.glib");
            ASSERT_TRUE(scene) << scene.message();
            if (isDrawn) {
                EXPECT_EQ(shownAt(*scene, 0), 1);
                EXPECT_EQ(shownAt(*scene, .2), 3);
            }
            ASSERT_TRUE(scene->write("v", std::vector<float>(4, 20)));
            EXPECT_EQ(shownAt(*scene, .5), isDrawn ? 23 : 25);
            ASSERT_TRUE(scene->write("v", std::vector<float>(4, 40)));
            EXPECT_EQ(shownAt(*scene, .6), 41);
            EXPECT_EQ(shownAt(*scene, .1), 41);  // it begins anew, with what was written
            ASSERT_TRUE(scene->reload());
            EXPECT_EQ(shownAt(*scene, .1), 2);
        }
}

TEST(LibraryWrite, ComesAfterWhatOnceMakes) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        simulating("Buffer v float 4",
                   "Once\nDispatch Begin over v\nEndOnce\nStep 10\nDispatch Inc over v\nEndStep\n"),
        "once.glib");
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->write("v", std::vector<float>(4, 20)));
    EXPECT_EQ(shownAt(*scene, 0), 20);
    EXPECT_EQ(shownAt(*scene, .2), 22);
}

TEST(LibraryWrite, IsWhatEachFrameBeginsWith) {
    Renderer renderer = opened();
    Result<Scene> scene =
        renderer.loadText(simulating("Buffer v float 4 (1)", "Dispatch Inc over v\n"), "frame.glib");
    ASSERT_TRUE(scene) << scene.message();
    for (const bool isFirst : {true, false}) {
        if (!isFirst) {
            EXPECT_EQ(shownAt(*scene, 0), 21);
        }
        ASSERT_TRUE(scene->write("v", std::vector<float>(4, 20)));
        EXPECT_EQ(shownAt(*scene, 0), 21);
        EXPECT_EQ(shownAt(*scene, 1), 21);
    }
    // Elements that were not written are as declared.
    Result<Scene> other =
        renderer.loadText(simulating("Buffer v float 4 (1)", "Dispatch Inc over v\n"), "frame.glib");
    ASSERT_TRUE(other) << other.message();
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(shownAt(*other, 0), i == 0 ? 2 : 31);
        ASSERT_TRUE(other->write("v", std::vector<float>(1, 30), 0));
        const std::vector<float> pixels = floatsOf(*other->draw(kFloats));
        EXPECT_EQ(pixels[0], 31);
        EXPECT_EQ(pixels[1], 2);
    }
}

TEST(LibraryWrite, IsNotReplacedByValuesThatChangeWithTime) {
    Renderer renderer = opened();
    Result<Scene> scene =
        renderer.loadText(showing("Let k 1\nBuffer v float 4 (k*time)",
                                  "layout(std430) readonly buffer v { float all[]; };", "vec4(all[0])"),
                          "time.glib");
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_EQ(shownAt(*scene, 3), 3);
    ASSERT_TRUE(scene->write("v", std::vector<float>(4, .5F)));
    EXPECT_EQ(shownAt(*scene, 5), .5F);
    ASSERT_TRUE(scene->set("k", 2.));
    EXPECT_EQ(shownAt(*scene, 6), .5F);
    ASSERT_TRUE(scene->reload());
    EXPECT_EQ(shownAt(*scene, 6), 12);
}

TEST(LibraryWrite, IsInATextureThatANodeWritesToo) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        showing(
            "Texture2D sum 4 3 r32f history\nFragment inline\n#version 430\nuniform sampler2D sum;\n"
            "out vec4 fColor;\nvoid main() { fColor = texelFetch(sum, ivec2(gl_FragCoord.xy), 0) + 1.; }\n"
            "EndFragment\nProgram Add sum sum.prev\nStep 10\nFill sum with Add\nEndStep",
            "uniform sampler2D sum;", "texelFetch(sum, at, 0)"),
        "sum.glib");
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_EQ(shownAt(*scene, .3), 3);
    ASSERT_TRUE(scene->write("sum", std::vector<float>(12, 50)));
    EXPECT_EQ(shownAt(*scene, .3), 50);
    EXPECT_EQ(shownAt(*scene, .5), 52);
    EXPECT_EQ(shownAt(*scene, .1), 51);
}

TEST(LibraryWrite, IsSeenByWhatThePictureDoesNotShow) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        showing("Texture2D field 4 3 r32f\nTexture2D twice 4 3 r32f\nBuffer v float 4\nFragment inline\n"
                "#version 430\nuniform sampler2D field;\nlayout(std430) readonly buffer v { float all[]; };\n"
                "out vec4 fColor;\nvoid main() { fColor = all[3] * texelFetch(field, ivec2(0), 0); }\n"
                "EndFragment\nProgram Twice\nFill twice with Twice",
                "uniform sampler2D field;\nlayout(std430) readonly buffer v { float all[]; };",
                "all[2] + texelFetch(field, at, 0)"),
        "twice.glib");
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->write("field", std::vector<float>(12, 3)));
    ASSERT_TRUE(scene->write("v", std::array{0.F, 0.F, 1.F, 2.F}));
    EXPECT_EQ(shownAt(*scene, 0), 4);
    const Result<Picture> twice = scene->target("twice");
    ASSERT_TRUE(twice) << twice.message();
    EXPECT_EQ(floatsOf(*twice).front(), 6);
}

TEST(LibraryWrite, OfWhatCannotBeWrittenIsAnErrorAndChangesNothing) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        showing("Texture3D volume 4 3 2 r32f\nTexture2D unused 4 4 r32f\nTexture2D soft 4 4 r32f samples 4\n"
                "Fragment inline\n#version 430\nout vec4 fColor;\nvoid main() { fColor = vec4(1); "
                "}\nEndFragment\n"
                "Program One\nFill soft with One",
                "uniform sampler3D volume; uniform sampler2D soft;",
                "texelFetch(volume, ivec3(at, 1), 0) + texelFetch(soft, at, 0)"),
        "errors.glib");
    ASSERT_TRUE(scene) << scene.message();
    const std::vector<float> texels(24, .5F);
    ASSERT_TRUE(scene->write("volume", texels));
    EXPECT_PRED2(isIn, scene->write("volum", texels).message(), "did you mean 'volume'? [library-E02]");
    EXPECT_PRED2(isIn, scene->write("volume.layer(1)", texels).message(), "as a whole");
    EXPECT_PRED2(isIn, scene->write("unused", texels).message(), "[library-E07]");
    EXPECT_PRED2(isIn, scene->write("soft", texels).message(), "samples");
    EXPECT_PRED2(
        isIn, scene->write("volume", std::vector<float>(23)).message(),
        "errors.glib:2:1: error: texture 'volume' (r32f) takes float32 of shape (2, 3, 4), found 23 x "
        "float32 [library-E03]");
    EXPECT_FALSE(scene->write("volume", texels, 0));
    DataView data{std::as_bytes(std::span(texels)), "float32", {4, 3, 2}, {}, 4};
    EXPECT_PRED2(isIn, scene->write("volume", data).message(), "found float32 of shape (4, 3, 2)");
    data.shape = {2, 3, 4, 1};
    EXPECT_TRUE(scene->write("volume", data));
    std::string message;
    std::thread([&] { message = scene->write("volume", texels).message(); }).join();
    EXPECT_PRED2(isIn, message, "gpu-E08");
    EXPECT_EQ(floatsOf(*scene->draw(kFloats)).front(), 1.5F);
    Scene moved = std::move(*scene);
    EXPECT_PRED2(isIn, scene->write("volume", texels).message(), "library-E05");
    EXPECT_TRUE(moved.write("volume", texels));
}

TEST(LibraryWrite, GivesContentToATextureThatNothingOfTheSceneWrites) {
    Renderer renderer = opened();
    RenderOptions strict;
    strict.strict = true;
    Result<Scene> scene =
        renderer.loadText(showing("Texture3D volume 4 3 2 r32f", kVolume, kTexel), "strict.glib", {}, strict);
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_PRED2(isIn, scene.message(), "warning: texture 'volume'");
    ASSERT_TRUE(scene->write("volume", std::vector<float>(24, .5F)));
    EXPECT_TRUE(scene->draw());
}

}  // namespace
}  // namespace glibra
