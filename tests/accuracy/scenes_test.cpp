#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "bench/subjects/scene_pictures.h"

namespace glibra::bench {
namespace {

namespace fs = std::filesystem;

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> shared = [] {
        Result<gpu::Context> opened = gpu::openContext();
        if (!opened) throw std::runtime_error("no driver");
        return std::make_unique<gpu::Context>(std::move(*opened));
    }();
    return *shared;
}

constexpr const char* kScene = "s.glib";  ///< there is no such file
constexpr const char* kVertex =
    "#version 330 core\nvoid main() {\n  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n";

/// A scene that fills 0 <= x < 3.375, 0 <= y < 8 of 8 x 8 pixels with the colour of the fragment shader.
RenderOptions quadScene(const std::string& rgb) {
    RenderOptions options;
    options.sceneText =
        "WindowSize 8 8\nOrtho 0 8 0 8\nLookAt 0 0 50 0 0 0 0 1 0\nBackground 0 0 0\n"
        "Vertex v.vert\nFragment f.frag\nProgram P\n"
        "glBegin quads\nglVertex -9 -9 0\nglVertex 3.375 -9 0\nglVertex 3.375 20 0\nglVertex -9 20 0\n"
        "glEnd\n";
    options.texts = {
        {"v.vert", kVertex},
        {"f.frag", "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(" + rgb + ", 1.); }\n"}};
    return options;
}

/// A scene that draws the same into a texture of 8 x 8 texels, and shows one texel over the whole window.
RenderOptions textureScene(double column) {
    RenderOptions options;
    options.sceneText =
        "WindowSize 4 4\nTexture2D 6 8 8\nRenderToTexture 6\nOrtho 0 8 0 8\n"
        "LookAt 0 0 50 0 0 0 0 1 0\nBackground 0 0 0\nVertex v.vert\nFragment white.frag\nProgram P\n"
        "glBegin quads\nglVertex -9 -9 0\nglVertex 3.375 -9 0\nglVertex 3.375 20 0\nglVertex -9 20 0\n"
        "glEnd\nRenderToTexture\nFragment texel.frag\nProgram Q uTexUnit 6\n"
        "glBegin quads\nglVertex -9 -9 0\nglVertex 20 -9 0\nglVertex 20 20 0\nglVertex -9 20 0\nglEnd\n";
    options.texts = {
        {"v.vert", kVertex},
        {"white.frag", "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n"},
        {"texel.frag",
         "#version 330 core\nuniform sampler2D uTexUnit;\nout vec4 fColor;\n"
         "void main() { fColor = texture(uTexUnit, vec2(" +
             std::to_string((column + .5) / 8) + ", .5)); }\n"}};
    return options;
}

/// The red component of a pixel of a float picture.
float redAt(const image::Image& picture, int x, int y) {
    float value = 0;
    std::memcpy(&value, picture.row(y).data() + static_cast<std::size_t>(x) * 3 * sizeof(float),
                sizeof value);
    return value;
}

TEST(SampledPicture, GivesEdgesInTexturesTheShareThatIsCovered) {
    for (const auto& [column, share] : {std::pair(2., 1.F), {3., .375F}, {4., 0.F}}) {
        const image::Image picture = sampledPicture(context(), kScene, textureScene(column), 8);
        EXPECT_NEAR(redAt(picture, 1, 1), share, 1e-5) << column;
    }
}

TEST(SampledPicture, GivesEdgesTheShareThatIsCovered) {
    const RenderOptions scene = quadScene("vec3(1.)");
    const image::Image picture = sampledPicture(context(), kScene, scene, 8);
    ASSERT_EQ(picture.width, 8);
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(redAt(picture, 2, y), 1);
        EXPECT_EQ(redAt(picture, 3, y), .375F);
        EXPECT_EQ(redAt(picture, 4, y), 0);
    }
    const Result<image::Image> plain = scenePicture(context(), kScene, scene);
    ASSERT_TRUE(plain);
    const PictureError error = pictureError(picture, *plain);
    EXPECT_NEAR(error.rootMeanSquare, .375 / std::sqrt(8), 1e-6);
    EXPECT_NEAR(error.differing, 1. / 8, 1e-12);
    EXPECT_GT(error.flip, 0);
}

TEST(SampledPicture, ShowsShadersThePlaceOfEachSample) {
    // Half of every pixel; a sample in the middle alone gives all or nothing.
    const RenderOptions scene = quadScene("vec3(step(.5, fract(gl_FragCoord.x + .001)))");
    const image::Image picture = sampledPicture(context(), kScene, scene, 8);
    EXPECT_EQ(redAt(picture, 1, 4), .5F);
}

TEST(SampledPicture, LimitsEachSampleToTheRangeOfAScreen) {
    const RenderOptions scene = quadScene("vec3(4., -4., 0.)");
    const image::Image picture = sampledPicture(context(), kScene, scene, 8);
    EXPECT_EQ(redAt(picture, 1, 1), 1);
    EXPECT_EQ(redAt(picture, 3, 1), .375F);  // 3 of 8 columns of samples
}

TEST(SampledPicture, OfOneSampleIsThePicture) {
    const std::vector<ShippedScene> scenes = shippedScenes();
    RenderOptions options;
    options.width = options.height = 64;
    for (const ShippedScene& scene : scenes) {
        if (!scene.name.starts_with("shading/") && !scene.name.starts_with("tessellation/")) continue;
        const image::Image sampled = sampledPicture(context(), scene.path, options, 1);
        const Result<image::Image> plain = scenePicture(context(), scene.path, options);
        ASSERT_TRUE(plain) << scene.name;
        const PictureError error = pictureError(sampled, *plain);
        EXPECT_LT(error.rootMeanSquare, .5 / 255) << scene.name;
        EXPECT_EQ(error.differing, 0) << scene.name;
    }
}

TEST(ShippedScenesOfTheBench, AreThoseOfTheLibraryAndTheirSlidersExist) {
    const std::vector<ShippedScene> scenes = shippedScenes();
    std::size_t files = 0;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib"))
        files += each.path().extension() == ".glib" ? 1 : 0;
    EXPECT_EQ(scenes.size(), files);
    EXPECT_TRUE(std::ranges::is_sorted(scenes, {}, &ShippedScene::name));
    int finest = 0;
    for (const ShippedScene& scene : scenes) {
        std::ostringstream text;
        text << std::ifstream(scene.path, std::ios::binary).rdbuf();
        for (const std::string& set : scene.finest) {
            ++finest;
            EXPECT_NE(text.str().find(set.substr(0, set.find('=')) + " <"), std::string::npos)
                << scene.name << ": " << set;
        }
    }
    EXPECT_EQ(finest, 13);
}

}  // namespace
}  // namespace glibra::bench
