#pragma once
// Shared by the tests of `library`: a renderer, and a scene with sliders.

#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::tests {

inline const std::filesystem::path kScenes = GLIBRA_SOURCE_DIR "/glib";

/// A renderer with the default driver.
inline Renderer opened() {
    Result<Renderer> renderer = Renderer::open();
    EXPECT_TRUE(renderer) << renderer.message();
    return std::move(*renderer);
}

inline bool isIn(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// A square that fills the picture with a colour.
inline constexpr const char* kSquare =
    "WindowSize 8 6\nBackground 0 0 0\nVertex square.vert\nFragment square.frag\n"
    "Program Square uColor {.2 .4 .6} uLevel <0 1 2> uOn <true> uCount [2 1 1]\nQuadXY 0 10\n";
inline const std::map<std::string, std::string> kShaders{
    {"square.vert",
     "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0, 1); }\n"},
    {"square.frag",
     "#version 330\nuniform vec3 uColor; uniform float uLevel; uniform bool uOn; uniform ivec3 uCount;\n"
     "out vec4 color;\nvoid main() { color = vec4(uOn ? uLevel * uColor * float(uCount.y) : vec3(1), 1); "
     "}\n"}};

/// The components of the lower left pixel.
inline std::vector<int> firstPixel(const Picture& picture) {
    std::vector<int> values;
    for (int i = 0; i < picture.components; ++i)
        values.push_back(std::to_integer<int>(picture.data[static_cast<std::size_t>(i)]));
    return values;
}

}  // namespace glibra::tests
