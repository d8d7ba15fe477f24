// Textures with names: formats, layers, levels, samples, comparison, and what a sampler may read.

#include <cstring>

#include "modern_by_hand.h"
#include "modern_squares.h"

namespace glibra::test {
namespace {

using base::TexelFormat;
using scene::TextureTarget;
using scene::TextureView;

/// A scene that draws a colour into a texture and shows what a fragment stage reads from it.
struct WriteAndRead {
    ModernScene modern{4, 4};
    scene::ProgramIndex writer, reader;

    explicit WriteAndRead(const std::string& read, const std::string& write = kConstant) {
        writer = modern.shading("Write", write);
        reader = modern.shading("Read", read);
    }
};

TEST(ModernTextures, HoldWhatWasDrawnIntoThemInEveryFormat) {
    // The colour is exact in 8 bits: 51 / 255 and 204 / 255.
    const std::array<double, 4> color{.2, .8, .4, 1};
    for (const base::TexelFormatRow& row : base::texelFormats()) {
        if (hasDepth(row.format)) continue;
        SCOPED_TRACE(std::string(row.name));
        const bool isSigned = row.kind == base::TexelClass::integer;
        const std::string kind = isInteger(row.format) ? (isSigned ? "i" : "u") : "";
        const std::string read =
            "uniform " + kind +
            "sampler2D uMap; out vec4 fColor; void main() { fColor = vec4(texture(uMap, vST))" +
            (kind.empty() ? ";" : " / 100.;") + " }";
        const std::string write = kind.empty() ? kConstant
                                               : "uniform vec4 uColor; out " + kind +
                                                     "vec4 fColor; void main() { fColor = " + kind +
                                                     "vec4(uColor * 100. + .5); }";
        WriteAndRead scene(read, write);
        const auto map = scene.modern.texture("uMap", row.format, 8, 8);
        scene.modern.pass({map}, glm::dvec4(0));
        scene.modern.set(scene.modern.square(scene.writer),
                         {{"uColor", {color[0], color[1], color[2], color[3]}}});
        scene.modern.window();
        scene.modern.square(scene.reader);  // by its name
        const ModernPicture picture = draw(scene.modern, {}, true);
        if (picture.image.data.empty()) {  // this driver cannot draw into it, and says so
            EXPECT_TRUE(has(picture.diagnostics, "gpu-E05")) << text(picture.diagnostics);
            continue;
        }
        const std::array<int, 3> found = picture.at(1, 2);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool exists = i < row.components;
            EXPECT_NEAR(found[i], exists ? color[i] * 255 : 0, row.bytes <= 4 ? 4 : 1) << "component " << i;
        }
    }
}

TEST(ModernTextures, AreZeroBeforeTheyAreWritten) {
    WriteAndRead scene(
        "uniform sampler2DArray uMap; out vec4 fColor; void main() { fColor = vec4(1.) - textureLod(uMap, "
        "vec3(vST, 2.), 1.); }");
    const auto map =
        scene.modern.texture("uMap", TexelFormat::rgba32f, 8, 8, TextureTarget::texture2DArray, 3);
    scene.modern.scene.textures[map].levels = 2;
    scene.modern.window();
    scene.modern.square(scene.reader);
    EXPECT_EQ(draw(scene.modern).at(2, 2), (std::array{255, 255, 255}));
}

TEST(ModernTextures, GiveTheirLayersAndFacesToPassesAndSamplers) {
    for (const TextureTarget target : {TextureTarget::texture2DArray, TextureTarget::cube}) {
        WriteAndRead scene(
            "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }");
        const auto map = scene.modern.texture("map", TexelFormat::rgba8, 4, 4, target, 6);
        for (int layer = 0; layer < 6; ++layer) {
            scene.modern.pass({map}, glm::dvec4(layer / 5., 0, 1 - layer / 5., 1)).parts = {{{}, layer}};
        }
        scene.modern.window();
        scene.modern.set(scene.modern.square(scene.reader), {}, {{"uMap", {.texture = map, .layer = 4}}});
        const ModernPicture picture = draw(scene.modern, {}, true);
        if (sharedContext().capabilities().atLeast(4, 3))
            EXPECT_EQ(picture.at(1, 1), (std::array{204, 0, 51})) << text(picture.diagnostics);
        else
            EXPECT_TRUE(has(picture.diagnostics, "draw-E10")) << text(picture.diagnostics);
    }
}

TEST(ModernTextures, GiveTheirLevelsToPassesAndSamplers) {
    // Each level is the mean of the one above it, drawn by passes that read one level and write the next.
    WriteAndRead scene(
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }",
        "out vec4 fColor; void main() { fColor = vec4(vST.s < .5 ? 1. : 0., 0., 0., 1.); }");
    const auto map = scene.modern.texture("map", TexelFormat::rgba8, 8, 8);
    scene.modern.scene.textures[map].levels = 3;
    scene.modern.scene.textures[map].sampler.filter = base::Filter::nearest;
    const auto halve = scene.modern.shading(
        "Halve",
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST) * .5; }");
    scene.modern.pass({map}, glm::dvec4(0));
    scene.modern.square(scene.writer);
    for (int level = 1; level < 3; ++level) {
        scene.modern.pass({map}, glm::dvec4(0)).parts = {{level, {}}};
        scene.modern.set(scene.modern.square(halve), {}, {{"uMap", {.texture = map, .level = level - 1}}});
    }
    scene.modern.window();
    scene.modern.set(scene.modern.square(scene.reader), {}, {{"uMap", {.texture = map, .level = 2}}});
    const ModernPicture picture = draw(scene.modern);
    EXPECT_NEAR(picture.at(0, 1)[0], 255 / 4, 1);
    EXPECT_EQ(picture.at(3, 1)[0], 0);
}

TEST(ModernTextures, MakeMipmapsAfterEachWriter) {
    WriteAndRead scene(
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = textureLod(uMap, vec2(.5), 3.); }",
        "out vec4 fColor; void main() { fColor = vec4(vST.s < .25 ? 1. : 0., vST.t < .5 ? 1. : 0., 1., 1.); "
        "}");
    const auto map = scene.modern.texture("uMap", TexelFormat::rgba8, 8, 8);
    scene.modern.scene.textures[map].hasMipmaps = true;
    scene.modern.scene.textures[map].sampler.filter = base::Filter::linearMipmapLinear;
    scene.modern.pass({map}, glm::dvec4(0));
    scene.modern.square(scene.writer);
    scene.modern.window();
    scene.modern.square(scene.reader);
    const std::array<int, 3> mean = draw(scene.modern).at(2, 1);
    EXPECT_NEAR(mean[0], 64, 1);
    EXPECT_NEAR(mean[1], 128, 1);
    EXPECT_EQ(mean[2], 255);
}

TEST(ModernTextures, AreResolvedWhereASamplerReadsSamples) {
    // The right edge of the square runs through the middle of a texel column.
    const auto modern = [](const char* read, int samples) {
        WriteAndRead scene(read, "out vec4 fColor; void main() { fColor = vec4(1.); }");
        const auto map = scene.modern.texture("uMap", TexelFormat::rgba8, 4, 4);
        scene.modern.scene.textures[map].samples = samples;
        scene.modern.scene.textures[map].sampler.filter = base::Filter::nearest;
        scene.modern.pass({map}, glm::dvec4(0));
        scene.modern.square(scene.writer, 0, .75);  // -.75..+.75 of -1..1: half of the outer texels
        scene.modern.window();
        scene.modern.square(scene.reader);
        return draw(scene.modern);
    };
    constexpr const char* kResolved =
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }";
    constexpr const char* kFirst =
        "uniform sampler2DMS uMap; out vec4 fColor; void main() { fColor = texelFetch(uMap, ivec2(vST * 4.), "
        "0); }";
    const ModernPicture resolved = modern(kResolved, 4);
    EXPECT_EQ(resolved.at(1, 1)[0], 255);
    EXPECT_GT(resolved.at(3, 1)[0], 60);
    EXPECT_LT(resolved.at(3, 1)[0], 195);
    const int single = modern(kFirst, 4).at(3, 1)[0];
    EXPECT_TRUE(single == 0 || single == 255) << single;
}

TEST(ModernTextures, OfDepthAreComparedOrReadByTheTypeOfTheSampler) {
    // Depth .25 at the left, .75 at the right.
    const auto modern = [](const std::string& read) {
        WriteAndRead scene(read);
        const auto shadow = scene.modern.texture("uMap", TexelFormat::depth32f, 8, 8);
        base::SamplerState& sampler = scene.modern.scene.textures[shadow].sampler;  // as a statement has it
        sampler.wrap.fill(base::Wrap::clampToBorder);
        sampler.border.fill(1);
        scene::Pass& pass = scene.modern.pass({}, {});
        pass.depth = TextureView{.texture = shadow};
        scene.modern.square(scene.writer, .5);
        scene.modern.square(scene.writer, -.5).raster.change().scissor = base::FractionRectangle{0, 0, .5, 1};
        scene.modern.window();
        scene.modern.square(scene.reader);
        return draw(scene.modern);
    };
    const ModernPicture raw = modern(
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = vec4(texture(uMap, vST).r); }");
    EXPECT_EQ(raw.at(0, 0)[0], 64);
    EXPECT_EQ(raw.at(3, 0)[0], 191);
    const ModernPicture compared = modern(
        "uniform sampler2DShadow uMap; out vec4 fColor; void main() { fColor = vec4(texture(uMap, vec3(vST, "
        ".5)), texture(uMap, vec3(vST, .25)), texture(uMap, vec3(3., 3., .9)), 1.); }");
    EXPECT_EQ(compared.at(0, 0), (std::array{0, 255, 255})) << ".5 > .25, .25 <= .25, outside 1";
    EXPECT_EQ(compared.at(3, 0), (std::array{255, 255, 255}));
}

TEST(ModernTextures, ThatDoNotFitTheSamplerAreErrors) {
    struct Case {
        const char* type;
        TextureTarget target;
        TexelFormat format;
        const char* advice;
    };
    for (const Case& each :
         {Case{"sampler2D", TextureTarget::cube, TexelFormat::rgba8, "write samplerCube"},
          Case{"sampler2D", TextureTarget::texture2D, TexelFormat::r32ui, "write usampler2D"},
          Case{"usampler2D", TextureTarget::texture2D, TexelFormat::rgba8, "write sampler2D"},
          Case{"sampler2DShadow", TextureTarget::texture2D, TexelFormat::r32f, "write sampler2D"}}) {
        const bool isShadow = std::string(each.type).ends_with("Shadow");
        WriteAndRead scene(std::string("uniform ") + each.type +
                           " uMap; out vec4 fColor; void main() { fColor = vec4(texture(uMap, " +
                           (isShadow ? "vec3(vST, .5)" : "vST") + ")); }");
        const auto map = scene.modern.texture("map", each.format, 4, 4, each.target);
        scene.modern.window();
        scene.modern.set(scene.modern.square(scene.reader), {}, {{"uMap", {.texture = map}}});
        const ModernPicture picture = draw(scene.modern, {}, true);
        EXPECT_TRUE(picture.image.data.empty());
        EXPECT_TRUE(has(picture.diagnostics, "draw-E09")) << text(picture.diagnostics);
        EXPECT_NE(text(picture.diagnostics).find(each.advice), std::string::npos)
            << text(picture.diagnostics);
        EXPECT_NE(text(picture.diagnostics).find("'map' (line "), std::string::npos);
    }
}

TEST(ModernTextures, MayNotBeSampledWhereTheyAreDrawnInto) {
    WriteAndRead scene(
        "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }");
    const auto map = scene.modern.texture("map", TexelFormat::rgba8, 8, 8);
    scene.modern.scene.textures[map].levels = 2;
    scene.modern.pass({map}, glm::dvec4(0)).parts = {{1, {}}};
    scene.modern.set(scene.modern.square(scene.reader), {}, {{"uMap", {.texture = map, .level = 1}}});
    scene.modern.window();
    scene.modern.set(scene.modern.square(scene.reader), {}, {{"uMap", {.texture = map}}});
    const ModernPicture picture = draw(scene.modern, {}, true);
    EXPECT_TRUE(has(picture.diagnostics, "draw-E01"));
    EXPECT_NE(text(picture.diagnostics).find("history"), std::string::npos) << text(picture.diagnostics);
}

TEST(ModernTextures, ExchangeTheirCopies) {
    // Two passes write; between them the copies change their places by hand.
    WriteAndRead scene(
        "uniform sampler2D uNow, uBefore; out vec4 fColor; void main() { fColor = vec4(texture(uNow, vST).r, "
        "texture(uBefore, vST).r, 0., 1.); }");
    const auto map = scene.modern.texture("map", TexelFormat::rgba8, 4, 4);
    scene.modern.scene.textures[map].hasHistory = true;
    scene.modern.pass({map}, glm::dvec4(1, 0, 0, 1));
    scene.modern.window();
    scene.modern.set(scene.modern.square(scene.reader), {},
                     {{"uNow", {.texture = map}}, {"uBefore", {.texture = map, .isPrevious = true}}});
    EXPECT_EQ(draw(scene.modern).at(1, 1), (std::array{255, 0, 0})) << "the other copy is as declared";
}

TEST(ModernTextures, AreSavedInTheTypeOfTheirFormat) {
    ModernScene modern(4, 4);
    const auto drawn = [&](const std::string& name, TexelFormat format, glm::dvec4 color) {
        const auto map = modern.texture(name, format, 2, 3);
        modern.pass({map}, color);
        return map;
    };
    const auto bytes = drawn("bytes", TexelFormat::rg8, {.2, .4, 0, 0});
    const auto shorts = drawn("shorts", TexelFormat::r16, {.5, 0, 0, 0});
    const auto floats = drawn("floats", TexelFormat::rgba32f, {-2, 1.5, 7, .25});
    const auto integers = drawn("integers", TexelFormat::r32i, {-70000, 0, 0, 0});
    const auto depth = modern.texture("depth", TexelFormat::depth32f, 2, 3);
    scene::Pass& pass = modern.pass({}, {});
    pass.depth = TextureView{.texture = depth};
    pass.depthValue = .375;
    const auto slices = modern.texture("slices", TexelFormat::r8, 2, 3, TextureTarget::texture2DArray, 4);
    modern.pass({slices}, glm::dvec4(1)).parts = {{{}, 2}};
    modern.window();

    RenderOptions options;
    options.wantedObjects = {"bytes", "shorts", "floats", "integers", "depth", "slices.layer(2)"};
    render::InterpretedScene interpreted;
    interpreted.scene = modern.scene;
    render::Stats stats;
    auto loaded = render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, stats);
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    ASSERT_TRUE(loaded->draw(0, stats));
    const auto image = [&](const TextureView& view) {
        const Result<image::Image> found = loaded->textureImage(view);
        EXPECT_TRUE(found) << text(found.diagnostics);
        return found ? *found : image::Image{};
    };
    const auto firstFloat = [](const image::Image& of, std::size_t index) {
        float value = 0;
        std::memcpy(&value, of.data.data() + index * sizeof value, sizeof value);
        return value;
    };
    const image::Image two = image({.texture = bytes});
    EXPECT_EQ(two.components, 3);
    EXPECT_EQ(two.width, 2);
    EXPECT_EQ(two.height, 3);
    EXPECT_EQ(std::to_integer<int>(two.data.at(0)), 51);
    EXPECT_EQ(std::to_integer<int>(two.data.at(1)), 102);
    const image::Image one = image({.texture = shorts});
    EXPECT_EQ(one.type, image::Component::u16);
    EXPECT_NEAR(std::to_integer<int>(one.data.at(1)) * 256 + std::to_integer<int>(one.data.at(0)), 32768, 1);
    EXPECT_EQ(firstFloat(image({.texture = floats}), 0), -2);
    EXPECT_EQ(firstFloat(image({.texture = floats}), 2), 7);
    EXPECT_EQ(firstFloat(image({.texture = integers}), 0), -70000);
    EXPECT_EQ(firstFloat(image({.texture = depth}), 5), .375F);
    EXPECT_EQ(std::to_integer<int>(image({.texture = slices, .layer = 2}).data.at(0)), 255);
    EXPECT_EQ(std::to_integer<int>(image({.texture = slices, .layer = 1}).data.at(0)), 0);
    EXPECT_NE(text(loaded->textureImage({.texture = slices}).diagnostics).find("slices.layer(0)"),
              std::string::npos);
}

TEST(ModernNames, OfTablesAndVariablesAreSuppliedWhereNothingSetsThem) {
    // Model: moved by 3 along x and scaled by 2; view: moved by 5 along -z.
    constexpr const char* kNamed = R"(#version 330 core
in vec3 vertPos;
in vec2 tc;
uniform mat4 m_matrix, v_matrix, proj_matrix, mv_matrix;
uniform mat4 mvp;
uniform mat3 normalMatrix;
uniform vec3 cameraPos;
out vec4 vFound;
out vec2 vST;
void main() {
    bool isRight = m_matrix[3].x == 3. && m_matrix[0].x == 2. && v_matrix[3].z == -5. && mv_matrix[3].z == -5. &&
                   mv_matrix[3].x == 3. && proj_matrix[0].x == .25 && mvp[3].x == .75 &&
                   normalMatrix[1].y == .5 && cameraPos == vec3(0., 0., 5.);
    vST = tc;
    vFound = isRight ? vec4(0., 1., 0., 1.) : vec4(1., 0., 0., 1.);
    gl_Position = vec4(vertPos.xyz, 1.);
}
)";
    ModernScene modern(4, 4);
    const auto named =
        modern.program("Named", {{glsl::Stage::vertex, kNamed}, {glsl::Stage::fragment, R"(#version 330 core
in vec4 vFound;
in vec2 vST;
uniform float brightness;
out vec4 fColor;
void main() { fColor = vec4(vFound.rg * brightness, vST.s, 1.); }
)"}});
    modern.scene.namedValues.push_back({"brightness", glib::UniformForm::number, {.6}, {1, 1}, {1, 1}});
    modern.window();
    scene::Draw& drawn = modern.square(named);
    drawn.model = glm::dmat4(2);
    drawn.model[3] = {3, 0, 0, 1};
    drawn.modelView = drawn.model;
    drawn.modelView[3].z = -5;
    glm::dmat4 projection(1);
    projection[0][0] = .25;
    drawn.projection = projection;
    const ModernPicture picture = draw(modern);
    EXPECT_EQ(picture.at(1, 1)[0], 0) << text(picture.diagnostics);
    EXPECT_EQ(picture.at(1, 1)[1], 153);
    EXPECT_GT(picture.at(3, 1)[2], 200) << "texture coordinates";
    EXPECT_FALSE(has(picture.diagnostics, "glib-W37")) << text(picture.diagnostics);

    modern.set(std::get<scene::Draw>(modern.scene.frame.passes.back().steps.back()), {{"brightness", {1}}});
    EXPECT_EQ(draw(modern).at(1, 1)[1], 255) << "what a draw sets comes before the variable";
}

}  // namespace
}  // namespace glibra::test
