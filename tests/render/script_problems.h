#pragma once
// For tests of scenes that state about themselves, with Expect lines, what must hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>

#include "render/check/answers.h"
#include "render/check/run_checks.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {

/// What code reads of messages stands in their fields as it stands in their texts.
inline void expectNamesInFields(const Diagnostics& diagnostics) {
    constexpr std::array<std::string_view, 4> kRead{"glib-W23", "draw-W03", "draw-W15", "glsl-W11"};
    for (const Diagnostic& each : diagnostics) {
        if (std::ranges::find(kRead, each.id) == kRead.end()) continue;
        const bool proposes = each.text.find("did you mean") != std::string::npos;
        EXPECT_EQ(proposes, !each.suggestion.empty()) << each.text;
        EXPECT_NE(each.text.find("'" + each.subject + "'"), std::string::npos) << each.text;
        EXPECT_TRUE(!proposes || each.text.find("'" + each.suggestion + "'") != std::string::npos)
            << each.text;
    }
}

/// The messages of drawing a scene and answering its checks; empty if all is well.
inline std::string problemsOf(const std::string& scene, const std::map<std::string, std::string>& files = {},
                              const RenderOptions& options = {}) {
    const SceneFolder folder(scene, files);
    const Diagnostics found = render::runChecks(sharedContext(), folder / "scene.glib", options);
    expectNamesInFields(found);
    return text(found);
}

/// A BMP picture of one colour, as blue, green, red.
inline std::string bmp(int width, int height, const std::string& color) {
    const auto number = [](int value) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
        return bytes;
    };
    std::string row;
    for (int x = 0; x < width; ++x) row += color;
    row.resize((row.size() + 3) / 4 * 4);
    std::string rows;
    for (int y = 0; y < height; ++y) rows += row;
    return "BM" + number(54 + static_cast<int>(rows.size())) + number(0) + number(54) + number(40) +
           number(width) + number(height) + std::string("\1\0\30\0", 4) + number(0) +
           number(static_cast<int>(rows.size())) + number(0) + number(0) + number(0) + number(0) + rows;
}

/// A program that shows the colour of the sampler `uT`, of this type, at these coordinates.
inline std::string showing(const std::string& type, const std::string& at) {
    return "Fragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform " + type +
           " uT;\nvoid main() { c = texture(uT, " + at + "); }\nEndFragment\n";
}

/// The program `Layers`, which covers that many layers at once for one point. `value` is a colour and may
/// read `vLayer`.
inline std::string coveringLayers(int layers, const std::string& value) {
    const std::string count = std::to_string(layers);
    return R"(Vertex inline
#version 410 core
void main() { gl_Position = vec4(0); }
EndVertex
Geometry inline
#version 410 core
layout(points) in;
layout(triangle_strip, max_vertices = )" +
           std::to_string(3 * layers) + R"() out;
flat out float vLayer;
void main() {
    for (int layer = 0; layer < )" +
           count + R"(; ++layer) {
        for (int i = 0; i < 3; ++i) {
            gl_Layer = layer;
            vLayer = float(layer);
            gl_Position = vec4(i == 1 ? 3 : -1, i == 2 ? 3 : -1, 0, 1);
            EmitVertex();
        }
        EndPrimitive();
    }
}
EndGeometry
Fragment inline
#version 410 core
flat in float vLayer;
out vec4 c;
void main() { c = )" +
           value + "; }\nEndFragment\nProgram Layers\n";
}

}  // namespace glibra::test
