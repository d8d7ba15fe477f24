// Textures, slots and noise as the interpreter records them (language, 2.4, 3.4, 8.3 and 9.5).

#include "scene/textures.h"

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

/// The texture in the slot at the draw; none if the slot is empty.
TextureIndex heldBy(const Scene& scene, const Draw& draw, int unit, TextureTarget target) {
    for (const Slot& slot : scene.slotTables[draw.slots])
        if (slot.unit == unit && slot.target == target) return slot.texture;
    return {};
}

const Texture& textureOf(const Scene& scene, TextureIndex index) {
    return scene.textures[index];
}

/// A raw texture: little-endian sizes, then texels.
std::string raw(const std::vector<std::uint32_t>& sizes, std::size_t texelBytes) {
    std::string bytes;
    std::size_t texels = 1;
    for (const std::uint32_t size : sizes) {
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(size >> 8 * i & 0xffU);
        texels *= size;
    }
    return bytes + std::string(texels * texelBytes, '\x7f');
}

TEST(Textures, NoiseLiesOnUnits2And3FromTheStart) {
    const Scene scene = run("Sphere\n");
    const Draw draw = drawsOf(scene).at(0);
    const TextureIndex noise2 = heldBy(scene, draw, 2, TextureTarget::texture2D);
    const TextureIndex noise3 = heldBy(scene, draw, 3, TextureTarget::texture3D);
    ASSERT_TRUE(noise2);
    ASSERT_TRUE(noise3);
    const auto& two = std::get<NoiseSource>(textureOf(scene, noise2).source);
    const auto& three = std::get<NoiseSource>(textureOf(scene, noise3).source);
    EXPECT_EQ(two.dimensions, 2);
    EXPECT_EQ(three.dimensions, 3);
    EXPECT_EQ(two.size, 64);
    EXPECT_EQ(three.size, 64);
    EXPECT_FALSE(heldBy(scene, draw, 2, TextureTarget::texture3D));
}

TEST(Textures, TheLastNoiseSizeCountsForTheWholeScene) {
    const Scene scene = run("Noise3D 32\nSphere\nNoise3D 128\nNoise2D 256\n");
    EXPECT_EQ(std::get<NoiseSource>(textureOf(scene, TextureIndex(0)).source).size, 256);
    EXPECT_EQ(std::get<NoiseSource>(textureOf(scene, TextureIndex(1)).source).size, 128);
}

TEST(Textures, EachDrawSeesWhatItsSlotsHoldAtItsPlace) {
    const Scene scene = run("Texture2D 6 a.bmp\nSphere\nTexture2D 6 b.bmp\nSphere\nSphere\n");
    const auto draws = drawsOf(scene);
    const auto nameAt = [&](std::size_t i) {
        const TextureIndex texture = heldBy(scene, draws.at(i), 6, TextureTarget::texture2D);
        const FileIndex file = std::get<PictureSource>(textureOf(scene, texture).source).files.at(0);
        return scene.files[file].name;
    };
    EXPECT_EQ(nameAt(0), "a.bmp");
    EXPECT_EQ(nameAt(1), "b.bmp");
    EXPECT_EQ(draws[1].slots, draws[2].slots) << "unchanged slots are shared";
    EXPECT_NE(draws[0].slots, draws[1].slots);
    EXPECT_EQ(scene.slotTables.size(), 2U);
}

TEST(Textures, OneUnitHoldsATextureForEachTarget) {
    const Scene scene =
        run("Texture2D 6 8 8\nTexture3D 6 8 8 8\nTexture1D 6 8\nCubeMap 6 a b c d e f\nSphere\n");
    const Draw draw = drawsOf(scene).at(0);
    const std::array targets{TextureTarget::texture1D, TextureTarget::texture2D, TextureTarget::texture3D,
                             TextureTarget::cube};
    for (const TextureTarget target : targets) {
        const TextureIndex texture = heldBy(scene, draw, 6, target);
        ASSERT_TRUE(texture);
        EXPECT_EQ(textureOf(scene, texture).target, target);
        EXPECT_EQ(textureOf(scene, texture).unit, 6);
    }
    EXPECT_EQ(idsOf(scene.diagnostics), "");
}

TEST(Textures, EmptyTexturesHaveSizesAndAFormat) {
    const Scene scene =
        run("Texture2D 6 640 480\nTexture3D 7 2 3 4 rgba16f\nTexture1D 8 5 R32F\nTexture2D 9 1 1 RGBA32F\n");
    const auto sourceOf = [&](std::size_t index) {
        return std::get<EmptySource>(scene.textures.at(index).source);
    };
    EXPECT_EQ(sourceOf(2).width, 640);
    EXPECT_EQ(sourceOf(2).height, 480);
    EXPECT_EQ(sourceOf(2).depth, 1);
    EXPECT_EQ(sourceOf(2).format, TexelFormat::rgba8);
    EXPECT_EQ(sourceOf(3).depth, 4);
    EXPECT_EQ(sourceOf(3).format, TexelFormat::rgba16f);
    EXPECT_EQ(sourceOf(4).width, 5);
    EXPECT_EQ(sourceOf(4).format, TexelFormat::r32f);
    EXPECT_EQ(sourceOf(5).format, TexelFormat::rgba32f);
}

TEST(Textures, TextureTakesItsDimensionFromTheNumberOfSizes) {
    const Scene scene = run("Texture 6 8\nTexture 6 8 8\nTexture 6 8 8 8\n");
    EXPECT_EQ(textureOf(scene, TextureIndex(2)).target, TextureTarget::texture1D);
    EXPECT_EQ(textureOf(scene, TextureIndex(3)).target, TextureTarget::texture2D);
    EXPECT_EQ(textureOf(scene, TextureIndex(4)).target, TextureTarget::texture3D);
}

TEST(Textures, TextureTakesItsDimensionFromTheContentOfTheFile) {
    const TemporaryFolder folder;
    folder.write("one.tex", raw({7}, 4));
    folder.write("two.tex", raw({3, 5}, 4));
    folder.write("three.tex", raw({2, 3, 4}, 16));
    folder.write("picture.tex", std::string("\x89PNG\r\n\x1a\n") + raw({2, 3, 4}, 16));
    folder.write("neither.tex", raw({7}, 4) + "x");
    EXPECT_EQ(targetOfFile(folder.path() / "one.tex"), TextureTarget::texture1D);
    EXPECT_EQ(targetOfFile(folder.path() / "two.tex"), TextureTarget::texture2D);
    EXPECT_EQ(targetOfFile(folder.path() / "three.tex"), TextureTarget::texture3D);
    EXPECT_EQ(targetOfFile(folder.path() / "picture.tex"), TextureTarget::texture2D);
    EXPECT_EQ(targetOfFile(folder.path() / "neither.tex"), TextureTarget::texture2D);
    EXPECT_EQ(targetOfFile(folder.path() / "absent.tex"), TextureTarget::texture2D);
    EXPECT_EQ(targetOfFile(folder.path()), TextureTarget::texture2D);
    const Scene scene = run("Texture 6 three.tex\nTexture2D 7 two.tex\n", folder.path() / "a.glib");
    EXPECT_EQ(textureOf(scene, TextureIndex(2)).target, TextureTarget::texture3D);
    EXPECT_EQ(textureOf(scene, TextureIndex(3)).target, TextureTarget::texture2D);
}

TEST(Textures, SizesWhoseProductOverflowsFitNothing) {
    const TemporaryFolder folder;
    const std::string sizes(12, '\xff');
    folder.write("huge.tex", sizes + std::string(1000, 'x'));
    EXPECT_EQ(targetOfFile(folder.path() / "huge.tex"), TextureTarget::texture2D);
    EXPECT_FALSE(holdsNoise(folder.path() / "huge.tex", 3, 64));
}

TEST(Textures, ACubeMapHasSixFiles) {
    const Scene scene = run("CubeMap 5 px nx py ny pz nz\n");
    const auto& source = std::get<PictureSource>(textureOf(scene, TextureIndex(2)).source);
    ASSERT_EQ(source.files.size(), 6U);
    std::string names;
    for (const FileIndex file : source.files) names += scene.files[file].name;
    EXPECT_EQ(names, "pxnxpynypznz");
}

TEST(Textures, StatementsThatNameTheSameFileShareItsReference) {
    const Scene scene = run("Texture2D 6 a.bmp\nTexture2D 7 a.bmp\nObj cow.obj\nObjAdj cow.obj\n");
    EXPECT_EQ(scene.files.size(), 2U);
    EXPECT_EQ(scene.textures.size(), 4U) << "but each statement owns a texture";
    EXPECT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(scene.shapes.at(0).file, scene.shapes.at(1).file);
}

TEST(Textures, ReplacingTheNoiseIsReported) {
    EXPECT_EQ(textsOf(run("Texture2D 2 a.bmp\nTexture3D 3 8 8 8\n").diagnostics),
              "1:1 glib-W36 the noise texture on unit 2 is replaced\n"
              "2:1 glib-W36 the noise texture on unit 3 is replaced");
    EXPECT_EQ(idsOf(run("Texture2D 2 a.bmp\nTexture2D 2 b.bmp\n").diagnostics), "glib-W36")
        << "it is gone already";
    EXPECT_EQ(idsOf(run("Texture3D 2 8 8 8\nTexture2D 3 a.bmp\nCubeMap 2 a b c d e f\n").diagnostics), "");
}

TEST(Textures, TheBuiltInNoiseReplacesAMissingNoiseFile) {
    const Scene scene =
        run("Texture3D 6 noise3d.064.tex\nTexture2D 7 C:\\tex\\Noise2D.128.tex\nTexture 8 noise3d.016.tex\n");
    const auto sourceOf = [&](std::size_t index) {
        return std::get<NoiseSource>(scene.textures.at(index).source);
    };
    EXPECT_EQ(sourceOf(2).dimensions, 3);
    EXPECT_EQ(sourceOf(2).size, 64);
    EXPECT_FALSE(sourceOf(2).file);
    EXPECT_EQ(textsOf(sourceOf(2).remarks),
              "1:13 file-W09 'noise3d.064.tex' not found; the built-in noise is used");
    EXPECT_EQ(sourceOf(3).dimensions, 2);
    EXPECT_EQ(sourceOf(3).size, 128);
    EXPECT_EQ(textureOf(scene, TextureIndex(4)).target, TextureTarget::texture3D);
    EXPECT_EQ(sourceOf(4).size, 16);
    EXPECT_EQ(idsOf(scene.diagnostics), "") << "who does not need the texture does not hear of it";
}

TEST(Textures, AnExistingNoiseFileIsUsed) {
    const TemporaryFolder folder;
    folder.write("noise3d.016.tex", raw({16, 16, 16}, 4));
    const Scene scene = run("Texture3D 6 noise3d.016.tex\n", folder.path() / "a.glib");
    EXPECT_TRUE(std::holds_alternative<PictureSource>(textureOf(scene, TextureIndex(2)).source));
}

TEST(Textures, ANoiseNameOfTheOtherDimensionIsAMissingFile) {
    const Scene scene = run("Texture2D 6 noise3d.064.tex\n");
    EXPECT_TRUE(std::holds_alternative<PictureSource>(textureOf(scene, TextureIndex(2)).source));
    EXPECT_EQ(idsOf(scene.files.at(0).remarks), "file-E01");
}

TEST(Textures, NoiseNamesHaveThreeDigitsAndASizeThatExists) {
    EXPECT_EQ(noiseNameOf("noise3d.400.tex")->size, 400);
    EXPECT_EQ(noiseNameOf("noise2d.4096.tex")->size, 4096);
    EXPECT_FALSE(noiseNameOf("noise3d.401.tex"));
    EXPECT_FALSE(noiseNameOf("noise3d.000.tex"));
    EXPECT_FALSE(noiseNameOf("noise3d.64.tex"));
    EXPECT_FALSE(noiseNameOf("noise3d..tex"));
    EXPECT_FALSE(noiseNameOf("noise3d.064.bmp"));
    EXPECT_FALSE(noiseNameOf("noise3d.-64.tex"));
    EXPECT_FALSE(noiseNameOf("noise4d.064.tex"));
    EXPECT_FALSE(noiseNameOf("noise3d.99999999999.tex"));
    EXPECT_FALSE(noiseNameOf(""));
    EXPECT_EQ(noiseFileName(3, 64), "noise3d.064.tex");
    EXPECT_EQ(noiseFileName(2, 1024), "noise2d.1024.tex");
}

TEST(Textures, NoiseBesideTheSceneIsUsedIfItFits) {
    const TemporaryFolder folder;
    folder.write("noise3d.016.tex", raw({16, 16, 16}, 4));
    const Scene scene = run("Noise3D 16\nSphere\n", folder.path() / "a.glib");
    const auto& noise = std::get<NoiseSource>(textureOf(scene, TextureIndex(1)).source);
    ASSERT_TRUE(noise.file);
    EXPECT_EQ(scene.files[noise.file].path, folder.path() / "noise3d.016.tex");
    EXPECT_EQ(textsOf(noise.remarks), "1:1 file-N01 noise is read from 'noise3d.016.tex' beside the scene");
    EXPECT_FALSE(std::get<NoiseSource>(textureOf(scene, TextureIndex(0)).source).file);
}

TEST(Textures, NoiseBesideTheSceneOfAnotherSizeIsIgnored) {
    const TemporaryFolder folder;
    folder.write("noise3d.064.tex", raw({16, 16, 16}, 4));
    folder.write("noise2d.064.tex", raw({64, 64}, 16));
    const Scene scene = run("Sphere\n", folder.path() / "a.glib");
    EXPECT_FALSE(std::get<NoiseSource>(textureOf(scene, TextureIndex(1)).source).file);
    EXPECT_EQ(textsOf(std::get<NoiseSource>(textureOf(scene, TextureIndex(1)).source).remarks),
              "1:1 file-W10 'noise3d.064.tex' does not hold 64 x 64 x 64 byte texels; it is ignored");
    EXPECT_EQ(textsOf(std::get<NoiseSource>(textureOf(scene, TextureIndex(0)).source).remarks),
              "1:1 file-W10 'noise2d.064.tex' does not hold 64 x 64 byte texels; it is ignored");
    EXPECT_TRUE(scene.files.empty());
}

TEST(Textures, AllEmptyTexturesTogetherHaveALimit) {
    std::string text;
    for (int unit = 4; unit < 8; ++unit)
        text += "Texture2D " + std::to_string(unit) + " 16384 16384\n";  // 1 GiB each
    EXPECT_EQ(idsOf(run(text).diagnostics), "");
    const Scene scene = run(text + "Texture2D 9 1 1\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "5:1 glib-E15 Texture2D 9 1 1 'RGBA8': all textures need 4,294,967,300 bytes; the limit is "
              "4,294,967,296");
}

TEST(TextureNames, APartOfSeveralCubeMapsHasALayerAndAFace) {
    const Scene scene = run("CubeMap lamps 4 rgba8 layers 2\nCubeMap sky 4 rgba8\nBox\n");
    const auto layerOf = [&](const char* name) {
        const Result<TextureView> view = textureNamed(scene, name);
        return view ? view->layer.value_or(-1) : -2;
    };
    EXPECT_EQ(layerOf("lamps"), -1);
    EXPECT_EQ(layerOf("lamps.layer(1).face(2)"), 8);
    EXPECT_EQ(layerOf("lamps.face(5).layer(0)"), 5);
    EXPECT_EQ(layerOf("sky.face(3)"), 3);
    EXPECT_EQ(layerOf("sky.face(-y)"), 3);
    EXPECT_EQ(layerOf("sky.face(+x)"), 0);
    EXPECT_EQ(layerOf("lamps.layer(1).face(-z)"), 11);
    EXPECT_EQ(layerOf("sky.face(+w)"), -2);
    EXPECT_EQ(layerOf("sky.layer(+x)"), -2);
    for (const char* wrong : {"lamps.layer(1)", "lamps.face(1)", "lamps.layer(2).face(0)",
                              "lamps.layer(400000000).face(0)", "lamps.layer(0).face(6)"})
        EXPECT_EQ(textsOf(textureNamed(scene, wrong).diagnostics),
                  "1:1  '" + std::string(wrong) +
                      "': 'lamps' has 2 layers; write lamps.layer(0).face(0), with a face from 0 to 5");
}

}  // namespace
}  // namespace glibra::scene
