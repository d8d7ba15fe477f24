// What a program reads of textures and buffers: every number as the shader wrote it.

#include <fmt/format.h>
#include <glibra/glibra.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "support.h"

namespace glibra {
namespace {

namespace fs = std::filesystem;

using tests::isIn;
using tests::kShaders;
using tests::opened;

/// A scene whose compute shader writes a buffer `all` of two elements. Its picture reads nothing of it.
std::string writing(const std::string& declarations, const std::string& layout, const std::string& block,
                    const std::string& statements) {
    return fmt::format(
        "WindowSize 4 4\nBuffer all 2\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n{}\n"
        "layout({}) buffer all {{ {} }};\nvoid main() {{ uint i = gl_GlobalInvocationID.x; {} }}\n"
        "EndCompute\nProgram Write\nDispatch Write 2 1 1\n",
        declarations, layout, block, statements);
}

Result<BufferContent> written(Renderer& renderer, const std::string& text) {
    Result<Scene> scene = renderer.loadText(text, "write.glib");
    if (!scene) return std::move(scene.diagnostics);
    if (Result<Picture> picture = scene->draw(); !picture) return std::move(picture.diagnostics);
    return scene->buffer("all");
}

const BufferContent::Column* columnNamed(const std::vector<BufferContent::Column>& columns,
                                         std::string_view name) {
    for (const BufferContent::Column& each : columns)
        if (each.name == name) return &each;
    return nullptr;
}

/// 1 2 3 ..., after `before` others.
std::vector<double> counted(std::size_t count, double before) {
    std::vector<double> all;
    for (std::size_t i = 1; i <= count; ++i) all.push_back(before + static_cast<double>(i));
    return all;
}

std::string joined(const std::vector<double>& numbers) {
    std::string text;
    for (const double each : numbers) text += fmt::format("{}{:.0f}.", text.empty() ? "" : ", ", each);
    return text;
}

struct TypeOfMember {
    const char* name;
    std::size_t numbers;
};

TEST(LibraryBuffer, GivesEveryNumberOfEveryTypeInEveryLayout) {
    Renderer renderer = opened();
    for (const char* layout : {"std430", "std140", "std430, row_major", "std140, row_major"})
        for (const auto& [type, count] : std::vector<TypeOfMember>{{"float", 1},
                                                                   {"vec2", 2},
                                                                   {"vec3", 3},
                                                                   {"vec4", 4},
                                                                   {"mat2", 4},
                                                                   {"mat3", 9},
                                                                   {"mat4", 16},
                                                                   {"mat2x3", 6},
                                                                   {"mat3x2", 6},
                                                                   {"mat2x4", 8},
                                                                   {"mat4x2", 8},
                                                                   {"mat3x4", 12},
                                                                   {"mat4x3", 12},
                                                                   {"dmat3", 9},
                                                                   {"dmat2x3", 6},
                                                                   {"dvec3", 3},
                                                                   {"double", 1}}) {
            const Result<BufferContent> content = written(
                renderer,
                writing(fmt::format("struct Element {{ float before; {} m; float after; }};", type), layout,
                        "Element e[];",
                        fmt::format("e[i].before = -1; e[i].after = -2; if (i == 0u) e[i].m = {0}({1}); else "
                                    "e[i].m = {0}({2});",
                                    type, joined(counted(count, 0)), joined(counted(count, 100)))));
            const std::string which = fmt::format("{} in {}", type, layout);
            ASSERT_TRUE(content) << which << content.message();
            const BufferContent::Column* column = columnNamed(content->columns, "m");
            const BufferContent::Column* after = columnNamed(content->columns, "after");
            ASSERT_TRUE(column != nullptr && after != nullptr) << which;
            EXPECT_EQ(column->count, count) << which;
            EXPECT_EQ(content->elements, 2U) << which;
            for (std::uint64_t i = 0; i < 2; ++i) {
                EXPECT_EQ(content->numbers(*column, i), counted(count, 100 * static_cast<double>(i)))
                    << which;
                EXPECT_EQ(content->numbers(*after, i), std::vector<double>{-2}) << which;
            }
            EXPECT_TRUE(content->numbers(*column, 2).empty());
        }
}

TEST(LibraryBuffer, GivesArraysOfMatricesAndBuffersOfThem) {
    Renderer renderer = opened();
    const Result<BufferContent> ofStructure =
        written(renderer, writing("struct Element { float before; mat3 q[2]; };", "std430", "Element e[];",
                                  "e[i].q[0] = mat3(1, 2, 3, 4, 5, 6, 7, 8, 9); "
                                  "e[i].q[1] = mat3(11, 12, 13, 14, 15, 16, 17, 18, 19);"));
    ASSERT_TRUE(ofStructure) << ofStructure.message();
    for (const auto& [name, before] : {std::pair("q[0]", 0.), std::pair("q[1]", 10.)}) {
        const BufferContent::Column* column = columnNamed(ofStructure->columns, name);
        ASSERT_NE(column, nullptr) << name;
        EXPECT_EQ(ofStructure->numbers(*column, 1), counted(9, before));
        EXPECT_EQ(column->stride, 0U);
    }
    const Result<BufferContent> ofMatrices =
        written(renderer, writing("", "std430", "mat3 e[];", "e[i] = mat3(1, 2, 3, 4, 5, 6, 7, 8, 9);"));
    ASSERT_TRUE(ofMatrices) << ofMatrices.message();
    ASSERT_EQ(ofMatrices->columns.size(), 1U);
    EXPECT_EQ(ofMatrices->numbers(ofMatrices->columns.front(), 1), counted(9, 0));
}

TEST(LibraryBuffer, GivesTheMembersBeforeTheArray) {
    Renderer renderer = opened();
    const Result<BufferContent> content =
        written(renderer, writing("", "std430", "uint count; mat3 turn; float e[];",
                                  "count = 4000000000u; turn = mat3(1, 2, 3, 4, 5, 6, 7, 8, 9); e[i] = 5;"));
    ASSERT_TRUE(content) << content.message();
    const BufferContent::Column* count = columnNamed(content->head, "count");
    const BufferContent::Column* turn = columnNamed(content->head, "turn");
    ASSERT_TRUE(count != nullptr && turn != nullptr);
    EXPECT_EQ(count->type, "uint");
    EXPECT_EQ(content->numbers(*count, 0, true), std::vector<double>{4e9});
    EXPECT_EQ(content->numbers(*turn, 0, true), counted(9, 0));
}

/// A value that an element divides by may have become one that it cannot.
TEST(LibraryBuffer, WithoutAValueFailsAtEachPictureThatWouldReadIt) {
    Result<Renderer> renderer = Renderer::open();
    ASSERT_TRUE(renderer) << renderer.message();
    const std::string shown =
        "Fragment inline\n#version 430\nlayout(std430) readonly buffer b { float v[]; };\nout vec4 fColor;\n"
        "void main() { fColor = vec4(v[7]); }\nEndFragment\nProgram Show\nFill window with Show\n";
    const std::string step =
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\nlayout(std430) buffer b { float v[]; "
        "};\n"
        "void main() { v[gl_GlobalInvocationID.x] += 1.; }\nEndCompute\nProgram Inc\n"
        "Step 10\nDispatch Inc over b\nEndStep\n";
    for (const std::string& text :
         {"Buffer b float 8 (0/(i - k))\n" + shown, "Buffer b float 8 (1/(i - k))\n" + step + shown}) {
        Result<Scene> scene = renderer->loadText("WindowSize 4 4\nLet k -1\n" + text, "b.glib");
        ASSERT_TRUE(scene) << scene.message();
        EXPECT_TRUE(scene->draw({.time = 0}));
        EXPECT_TRUE(scene->draw({.time = .2}));
        ASSERT_TRUE(scene->set("k", 4.));
        EXPECT_PRED2(isIn, scene->draw({.time = 0}).message(), "division by zero") << text;
        ASSERT_TRUE(scene->set("k", -1.));
        EXPECT_TRUE(scene->draw({.time = 0})) << text;
    }
}

TEST(LibraryBuffer, OfNoneIsAnError) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        writing("", "std430", "float e[];", "e[i] = 5;") + "Buffer none float 4\n", "none.glib");
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_PRED2(isIn, scene->buffer("all").message(), "library-E04");
    ASSERT_TRUE(scene->draw());
    EXPECT_TRUE(scene->buffer("all"));
    EXPECT_FALSE(scene->buffer("al"));
    const Result<BufferContent> unused = scene->buffer("none");  // of four zeros
    ASSERT_TRUE(unused) << unused.message();
    EXPECT_EQ(unused->elements, 4U);
}

/// A scene with a texture of that format, into which every pixel writes these numbers.
std::string filling(const char* format, const char* type, const std::string& numbers) {
    return fmt::format(
        "WindowSize 4 4\nTexture2D made 3 2 {0}\nPass made\nVertex square.vert\nFragment inline\n"
        "#version 430\nout {1} color;\nvoid main() {{ color = {1}({2}); }}\nEndFragment\n"
        "Program Fill\nQuadXY 0 10\nEndPass\nPass window clear {{.5 .5 .5}}\nEndPass\n",
        format, type, numbers);
}

template <class Number>
std::vector<double> firstNumbers(const Picture& picture) {
    std::vector<double> all;
    for (int i = 0; i < picture.components; ++i) {
        Number number{};
        std::memcpy(&number, picture.data.data() + static_cast<std::size_t>(i) * sizeof number,
                    sizeof number);
        all.push_back(static_cast<double>(number));
    }
    return all;
}

std::vector<double> numbersOf(const Picture& picture) {
    if (picture.isFloat) return firstNumbers<float>(picture);
    if (picture.bits == 8)
        return picture.isSigned ? firstNumbers<std::int8_t>(picture) : firstNumbers<std::uint8_t>(picture);
    if (picture.bits == 16)
        return picture.isSigned ? firstNumbers<std::int16_t>(picture) : firstNumbers<std::uint16_t>(picture);
    return picture.isSigned ? firstNumbers<std::int32_t>(picture) : firstNumbers<std::uint32_t>(picture);
}

Result<Picture> filled(Renderer& renderer, const char* format, const char* type, const std::string& numbers) {
    Result<Scene> scene = renderer.loadText(filling(format, type, numbers), "fill.glib",
                                            {{"square.vert", kShaders.at("square.vert")}});
    if (!scene) return std::move(scene.diagnostics);
    if (Result<Picture> picture = scene->draw(); !picture) return std::move(picture.diagnostics);
    return scene->target("made");
}

TEST(LibraryTexture, OfIntegersHasTheIntegersOfItsFormat) {
    Renderer renderer = opened();
    struct Case {
        const char* suffix;
        int bits;
        bool isSigned;
        std::vector<double> numbers;
    };
    const std::vector<Case> cases{{"8ui", 8, false, {255, 1, 0, 7}},
                                  {"16ui", 16, false, {65535, 1, 0, 7}},
                                  {"32ui", 32, false, {4294967295., 16777217, 0, 7}},
                                  {"8i", 8, true, {-128, 127, 0, -1}},
                                  {"16i", 16, true, {-32768, 32767, 0, -1}},
                                  {"32i", 32, true, {-2147483647, 16777217, 2147483647, -1}}};
    for (const Case& each : cases)
        for (const int components : {1, 2, 4}) {
            const std::string format = std::string(components == 1   ? "r"
                                                   : components == 2 ? "rg"
                                                                     : "rgba") +
                                       each.suffix;
            std::string numbers;
            for (const double number : each.numbers)
                numbers +=
                    fmt::format("{}{:.0f}{}", numbers.empty() ? "" : ", ", number, each.isSigned ? "" : "u");
            const Result<Picture> picture =
                filled(renderer, format.c_str(), each.isSigned ? "ivec4" : "uvec4", numbers);
            ASSERT_TRUE(picture) << format << picture.message();
            EXPECT_EQ(picture->width, 3);
            EXPECT_EQ(picture->height, 2);
            EXPECT_EQ(picture->components, components) << format;
            EXPECT_FALSE(picture->isFloat) << format;
            EXPECT_EQ(picture->bits, each.bits) << format;
            EXPECT_EQ(picture->isSigned, each.isSigned) << format;
            EXPECT_EQ(numbersOf(*picture),
                      std::vector<double>(each.numbers.begin(), each.numbers.begin() + components))
                << format;
        }
}

TEST(LibraryTexture, KeepsItsNumberOfComponents) {
    Renderer renderer = opened();
    struct Case {
        const char* format;
        int components, bits;
        bool isFloat;
    };
    for (const Case& each :
         {Case{"r8", 1, 8, false}, Case{"rg8", 2, 8, false}, Case{"rgba8", 4, 8, false},
          Case{"rg16", 2, 16, false}, Case{"rg16f", 2, 32, true}, Case{"r32f", 1, 32, true},
          Case{"rg8_snorm", 2, 32, true}, Case{"r11f_g11f_b10f", 3, 32, true}}) {
        const Result<Picture> picture = filled(renderer, each.format, "vec4", "1., 0., 1., 0.");
        ASSERT_TRUE(picture) << each.format << picture.message();
        EXPECT_EQ(picture->components, each.components) << each.format;
        EXPECT_EQ(picture->bits, each.bits) << each.format;
        EXPECT_EQ(picture->isFloat, each.isFloat) << each.format;
        EXPECT_FALSE(picture->isSigned) << each.format;
        EXPECT_GT(numbersOf(*picture).front(), 0) << each.format;
    }
}

TEST(LibraryTexture, OfIntegersIsComparedNumberByNumber) {
    Renderer renderer = opened();
    const Result<Picture> one = filled(renderer, "rg32ui", "uvec2", "16777217u, 4294967295u");
    const Result<Picture> other = filled(renderer, "rg32ui", "uvec2", "16777216u, 4294967295u");
    ASSERT_TRUE(one && other);
    EXPECT_TRUE(compare(*one, *one).same);
    const Comparison found = compare(*one, *other);
    EXPECT_FALSE(found.same);
    EXPECT_EQ(found.largest, 1);
    EXPECT_EQ(found.differingPixels, 6U);
    EXPECT_TRUE(compare(*one, *other, {.absolute = 1}).same);
    EXPECT_FALSE(compare(*one, *other, {.absolute = 1, .exact = true}).same);
    EXPECT_FALSE(compare(*one, Picture{3, 2, 1, false, false, 8, std::vector<std::byte>(6)}).same);
}

TEST(LibraryTexture, OfIntegersIsSavedWithItsNumbersOrNotAtAll) {
    Renderer renderer = opened();
    const fs::path folder = fs::temp_directory_path() / ("glibra_integers_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const Result<Picture> fits = filled(renderer, "rgba32i", "ivec4", "-16777216, 5, 16777216, 0");
    const Result<Picture> tooLarge = filled(renderer, "r32ui", "uint", "16777217u");
    const Result<Picture> bytes = filled(renderer, "r8ui", "uint", "7u");
    ASSERT_TRUE(fits && tooLarge && bytes);
    for (const char* name : {"a.png", "a.tif", "a.jpg"}) {
        EXPECT_PRED2(isIn, fits->save(folder / name).message(), "library-E06") << name;
        EXPECT_FALSE(fs::exists(folder / name));
    }
    EXPECT_PRED2(isIn, tooLarge->save(folder / "a.exr").message(), "16777217");
    const Result<void> saved = fits->save(folder / "a.exr");
    EXPECT_TRUE(saved) << saved.message();
    EXPECT_TRUE(compare(*fits, folder / "a.exr").same) << compare(*fits, folder / "a.exr").reason;
    ASSERT_TRUE(bytes->save(folder / "b.png"));
    EXPECT_TRUE(compare(*bytes, folder / "b.png", {.exact = true}).same);
    fs::remove_all(folder);
}

TEST(LibraryCompare, RefusesToleranceThatNoDifferenceExceeds) {
    const Picture dark{2, 2, 1, true, false, 32, std::vector<std::byte>(16)};
    Picture bright = dark;
    const float value = .8F;
    for (std::size_t i = 0; i < 4; ++i) std::memcpy(bright.data.data() + 4 * i, &value, sizeof value);
    std::vector<Tolerance> wrong;
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity(), -1.})
        for (double Tolerance::* const member : {&Tolerance::largest, &Tolerance::fraction, &Tolerance::bias,
                                                 &Tolerance::relative, &Tolerance::absolute})
            wrong.emplace_back().*member = bad;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -.5, 1.5}) {
        wrong.emplace_back().flip = bad;
        wrong.emplace_back().structure = bad;
    }
    wrong.emplace_back().cluster = -1;
    wrong.emplace_back().line = -1;
    wrong.emplace_back().fraction = 2;
    const fs::path file =
        fs::temp_directory_path() / ("glibra_tolerance_" + std::to_string(::getpid()) + ".pfm");
    ASSERT_TRUE(dark.save(file));
    for (const Tolerance& each : wrong)
        for (const Comparison& found : {compare(bright, dark, each), compare(dark, dark, each),
                                        compare(bright, file, each), compare(file, file, each)}) {
            EXPECT_FALSE(found.same);
            ASSERT_EQ(found.diagnostics.size(), 1U);
            EXPECT_EQ(found.diagnostics.front().id, "library-E01");
            EXPECT_EQ(found.reason, found.diagnostics.front().text);
        }
    fs::remove(file);
    EXPECT_PRED2(isIn, compare(dark, "no/such/none.png").reason, "no/such/none.png");
}

}  // namespace
}  // namespace glibra
