// `glibra render --save`: textures of a scene as files.

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "image/read.h"
#include "program.h"

namespace glibra::test {
namespace {

/// A colour texture with two levels, and a depth texture. The window shows neither.
constexpr const char* kSaveScene = R"(WindowSize 16 16
Texture2D halves 8 8 rgba8 levels 2
Texture2D deep 8 4 depth32f
Fragment inline
#version 330 core
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(vST.s < .5 ? 1. : 0., vST.t < .5 ? 1. : 0., .2, 1.); }
EndFragment
Program Halves
Fill halves with Halves
Fill halves.level(1) with Halves
Pass deep clear depth .25
EndPass
Fill window with Halves
)";

std::array<int, 3> pixel(const image::Image& image, int x, int y) {
    const auto row = image.row(y);
    const std::size_t first = static_cast<std::size_t>(x) * static_cast<std::size_t>(image.components);
    return {std::to_integer<int>(row[first]), std::to_integer<int>(row[first + 1]),
            std::to_integer<int>(row[first + 2])};
}

TEST(Save, WritesLayersOf1DArraysRectanglesAndMeansOfSamples) {
    const Folder folder;
    folder.write("a.glib", R"(WindowSize 4 4
Texture1DArray rows 4 2 rgba8
TextureRect rect 4 2 rgba8
Texture2DArray soft 4 2 2 rgba8 samples 4
Pass rows.layer(1) clear {1 0 .2 1}
EndPass
Pass rect clear {1 0 .2 1}
EndPass
Pass soft.layer(1) clear {1 0 .2 1}
EndPass
)");
    const Finished run = glibra(folder.path(),
                                "render a.glib -o a.png --save 'rows.layer(1)=row.png' --save rect=rect.png "
                                "--save 'soft.layer(1)=soft.png'");
    ASSERT_EQ(run.status, 0) << run.err;
    for (const char* name : {"row.png", "rect.png", "soft.png"}) {
        const auto saved = image::readImage(folder / name);
        ASSERT_TRUE(saved) << name;
        EXPECT_EQ(saved->width, 4) << name;
        EXPECT_EQ(saved->height, name == std::string_view("row.png") ? 1 : 2) << name;
        EXPECT_EQ(pixel(*saved, 3, 0), (std::array{255, 0, 51})) << name;
    }
    EXPECT_NE(glibra(folder.path(), "render a.glib -o a.png --save rows=rows.png")
                  .err.find("it has 2 layers; name one, as rows.layer(0)"),
              std::string::npos);
}

TEST(Save, WritesTexturesAndTheirParts) {
    const Folder folder;
    folder.write("a.glib", kSaveScene);
    const Finished run = glibra(folder.path(),
                                "render a.glib -o a.png --save halves=whole.png --save "
                                "'halves.level(1)=part.png' --save deep=deep.exr");
    ASSERT_EQ(run.status, 0) << run.err;
    const auto whole = image::readImage(folder / "whole.png");
    const auto part = image::readImage(folder / "part.png");
    ASSERT_TRUE(whole && part);
    EXPECT_EQ(whole->width, 8);
    EXPECT_EQ(part->width, 4);
    for (const image::Image* each : {&*whole, &*part}) {
        EXPECT_EQ(pixel(*each, 0, 0), (std::array{255, 0, 51})) << "top left";
        EXPECT_EQ(pixel(*each, each->width - 1, each->height - 1), (std::array{0, 255, 51}));
    }
    const auto deep = image::readImage(folder / "deep.exr");
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->width, 8);
    EXPECT_EQ(deep->height, 4);
    ASSERT_EQ(deep->type, image::Component::f32);
    float depth = 0;
    std::memcpy(&depth, deep->data.data(), sizeof depth);
    EXPECT_EQ(depth, .25F);
}

TEST(Save, WritesAFilePerFrameAlsoInASandbox) {
    const Folder folder;
    folder.write("a.glib", kSaveScene);
    const Finished run =
        glibra(folder.path(), "render a.glib -o a.png --frames 2 --save halves=h.png --untrusted");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(folder.listing(), "a.glib\na_0000.png\na_0001.png\nh_0000.png\nh_0001.png\n");
}

TEST(Save, ReportsWhatItCannotSave) {
    const Folder folder;
    folder.write("a.glib", kSaveScene);
    const auto save = [&](const std::string& what) {
        return glibra(folder.path(), "render a.glib -o a.png --save " + what);
    };
    EXPECT_EQ(save("halves").status, 2);
    EXPECT_EQ(save("halves=a.png").status, 2) << "the name of the picture";
    const Finished unknown = save("halvs=x.png");
    EXPECT_EQ(unknown.status, 3);
    EXPECT_NE(unknown.err.find("did you mean 'halves'"), std::string::npos) << unknown.err;
    EXPECT_NE(save("'halves.level(2)=x.png'").err.find("has 2 levels"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
