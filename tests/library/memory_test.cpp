// Scenes wholly in memory: texts, shaders, what they include, pictures, models, buffers.

#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "support.h"

namespace glibra {
namespace {

using Files = std::map<std::string, std::string>;

std::vector<int> drawnPixel(Scene& scene) {
    const Result<Picture> picture = scene.draw();
    EXPECT_TRUE(picture) << picture.message();
    std::vector<int> values;
    for (std::size_t i = 0; picture && i < 3; ++i) values.push_back(std::to_integer<int>(picture->data[i]));
    return values;
}

constexpr const char* kFlat =
    "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0, 1); }\n";

/// Two by two pixels; the lower left one is blue.
std::string picture() {
    std::string file = "P6 2 2 255\n";
    for (const int each : {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}) file += static_cast<char>(each);
    return file;
}

template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

constexpr const char* kClassic =
    "WindowSize 8 8\nBackground 0 0 0\nTexture2D 5 pictures/photo.ppm\n"
    "Vertex flat.vert\nFragment photo.frag\nProgram Photo uPhoto 5\nObj square.obj\n";

Files classicFiles() {
    return {{"flat.vert", kFlat},
            {"photo.frag",
             "#version 330\n#include \"lib/tint.glsl\"\nuniform sampler2D uPhoto;\nout vec4 color;\n"
             "void main() { color = texture(uPhoto, vec2(.25)) * tint; }\n"},
            {"lib/tint.glsl", "const vec4 tint = vec4(1., 1., .6, 1.);\n"},
            {"pictures/photo.ppm", picture()},
            {"square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"}};
}

TEST(SceneInMemory, NeedsNoFileOfTheDisk) {
    Renderer renderer = tests::opened();
    for (const char* name : {"scene.glib", "no/such/folder/scene.glib", "./scene.glib"}) {
        Result<Scene> scene = renderer.loadText(kClassic, name, classicFiles());
        ASSERT_TRUE(scene) << scene.message();
        EXPECT_EQ(drawnPixel(*scene), (std::vector<int>{0, 0, 153})) << name;
        ASSERT_TRUE(scene->reload());
        EXPECT_EQ(drawnPixel(*scene), (std::vector<int>{0, 0, 153})) << name;
    }
}

TEST(SceneInMemory, HasOtherPicturesUnderTheSameNames) {
    Renderer renderer = tests::opened();
    Result<Scene> first = renderer.loadText(kClassic, "scene.glib", classicFiles());
    Files files = classicFiles();
    files["pictures/photo.ppm"].replace(files["pictures/photo.ppm"].size() - 6, 3, "\xff\x33\xff");
    Result<Scene> second = renderer.loadText(kClassic, "scene.glib", files);
    ASSERT_TRUE(first && second) << first.message() << second.message();
    EXPECT_EQ(drawnPixel(*second), (std::vector<int>{255, 51, 153}));
    EXPECT_EQ(drawnPixel(*first), (std::vector<int>{0, 0, 153}));
}

constexpr const char* kModern =
    "WindowSize 8 8\nBackground 0 0 0\nTexture2D photo photo.tex\nBuffer numbers vec4 numbers.bin\n"
    "Include part.glib\nVertex flat.vert\nFragment all.frag\n"
    "Program All uWide (photo.size.x) uLevel (level)\nQuadXY 0 10\nExpect pixel 1 1 [.8 .2 .4] within .01\n";

TEST(SceneInMemory, IsReadThroughAFunction) {
    Files files{
        {"flat.vert", kFlat},
        {"all.frag",
         "#version 430\nuniform sampler2D photo; uniform float uWide, uLevel;\n"
         "layout(std430) buffer numbers { vec4 all[]; };\nout vec4 color;\nvoid main() {\n"
         "    color = vec4(texelFetch(photo, ivec2(0), 0).r * uWide / 2.5, all[1].y, uLevel, 1);\n}\n"},
        {"part.glib", "Let level .4\n"},
        {"photo.tex", bytesOf<std::int32_t>({2, 2}) + std::string(16, '\xff')},
        {"numbers.bin", bytesOf<float>({0, 0, 0, 0, 0, .2F, 0, 0})}};
    std::set<std::string> asked;
    Renderer renderer = tests::opened();
    Result<Scene> scene = renderer.loadText(
        kModern, "made/scene.glib", [&](const std::filesystem::path& path) -> std::optional<std::string> {
            if (path.parent_path() != "made") return std::nullopt;
            const auto found = files.find(path.filename());
            if (found == files.end()) return std::nullopt;
            asked.insert(found->first);
            return found->second;
        });
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_EQ(asked.size(), files.size());
    EXPECT_EQ(drawnPixel(*scene), (std::vector<int>{204, 51, 102}));
    EXPECT_EQ(toString(scene->check()), "");
    const Result<Picture> texture = scene->target("photo");
    ASSERT_TRUE(texture) << texture.message();
    EXPECT_EQ(texture->width, 2);
    // A reload asks again.
    files["part.glib"] = "Let level .6\n";
    ASSERT_TRUE(scene->reload());
    EXPECT_EQ(drawnPixel(*scene), (std::vector<int>{204, 51, 153}));
}

TEST(SceneInMemory, IsFoundByLoadAndRenderToo) {
    RenderOptions options;
    options.reader = std::make_shared<const FileReader>(
        [files = classicFiles()](const std::filesystem::path& path) -> std::optional<std::string> {
            if (path == "mem/scene.glib") return kClassic;
            const auto found = files.find(path.lexically_relative("mem"));
            return found == files.end() ? std::nullopt : std::optional(found->second);
        });
    Renderer renderer = tests::opened();
    Result<Scene> scene = renderer.load("mem/scene.glib", options);
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_EQ(drawnPixel(*scene), (std::vector<int>{0, 0, 153}));
    options.within = std::filesystem::temp_directory_path();  // what a program gives is allowed anywhere
    const Result<Picture> picture = renderer.render("mem/scene.glib", options);
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(std::to_integer<int>(picture->data[2]), 153);
}

TEST(SceneInMemory, ReportsMistakesWithTheirPlaces) {
    const auto messageWith = [](const std::string& name, const std::optional<std::string>& content) {
        Files files = classicFiles();
        files.erase(name);
        if (content) files[name] = *content;
        Renderer renderer = tests::opened();
        const Result<Scene> scene = renderer.loadText(kClassic, "scene.glib", files);
        EXPECT_FALSE(scene) << name;
        return scene.message();
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_PRED2(has, messageWith("pictures/photo.ppm", std::nullopt),
                 "scene.glib:3:13: error: cannot find 'pictures/photo.ppm'");
    EXPECT_PRED2(has, messageWith("pictures/photo.ppm", "P6 2 2 255\nxx"), "'photo.ppm'");
    EXPECT_PRED2(has, messageWith("pictures/photo.ppm", ""), "'photo.ppm' is empty");
    EXPECT_PRED2(has, messageWith("square.obj", "v 1 2 3\nf 1 2 9\n"), "square.obj:2");
    EXPECT_PRED2(has, messageWith("lib/tint.glsl", std::nullopt), "lib/tint.glsl");
    // The driver's message quotes the shader.
    const std::string broken = messageWith("lib/tint.glsl", "\nconst vec4 tint = brocken;\n");
    EXPECT_PRED2(has, broken, "lib/tint.glsl:2:");
    EXPECT_PRED2(has, broken, "brocken");
}

}  // namespace
}  // namespace glibra
