// The camera of a Fill in Once and Step: its matrices are those of the moment, and what lasts begins anew
// only if a program reads them.

#include <cmath>

#include "../gpu/stored_numbers.h"
#include "modern_text.h"

namespace glibra::test {
namespace {

/// A camera at z = `z`, a program `Eye` that writes its place / 10, `Plain`, which reads no matrix, and
/// `Show`.
std::string eyeScene(const std::string& z) {
    return "WindowSize 4 4\nLet away <0. 0. 5.>\nCamera eye LookAt 0 0 (" + z +
           R"()  0 0 0  0 1 0  Perspective 60 1 20
Texture2D a 2 2 rgba8 nearest
Texture2D b 2 2 rgba8 nearest history
Fragment inline
#version 330 core
uniform mat4 invView;
uniform mat4 p_matrix;
out vec4 fColor;
void main() { fColor = vec4(invView[3].z / 10., p_matrix[1][1] / 10., 0., 1.); }
EndFragment
Program Eye
Fragment inline
#version 330 core
out vec4 fColor;
void main() { fColor = vec4(.2); }
EndFragment
Program Plain
Fragment inline
#version 330 core
uniform sampler2D uT;
out vec4 fColor;
void main() { fColor = texelFetch(uT, ivec2(0), 0) + vec4(.2, 0., 0., 0.); }
EndFragment
Program Add uT b.prev
Fragment inline
#version 330 core
uniform sampler2D uA, uB;
in vec2 vST;
out vec4 fColor;
void main() { fColor = vST.x < .5 ? texture(uA, vST) : texture(uB, vST); }
EndFragment
Program Show uA a uB b
)";
}

TEST(LastingFills, SeeTheCameraInOnce) {
    TextScene still(eyeScene("4") + "Once\nFill a with Eye\nEndOnce\nClear b\nFill window with Show\n");
    EXPECT_EQ(byteAt(still.draw(), 0, 0), 102);
    EXPECT_NEAR(byteAt(still.draw(), 0, 0, 1), 255 / std::tan(3.14159265 / 6) / 10, .51);
    // The block runs again when the camera changes, whether by time or by a variable.
    TextScene moving(eyeScene("4 + time + away") +
                     "Once\nFill a with Eye\nEndOnce\nClear b\nFill window with Show\n");
    EXPECT_EQ(byteAt(moving.draw(0), 0, 0), 102);
    expectStored(byteAt(moving.draw(1), 0, 0), 127.5);
    RenderOptions options;
    options.set = {"away=2"};
    TextScene set(
        eyeScene("4 + time + away") + "Once\nFill a with Eye\nEndOnce\nClear b\nFill window with Show\n", {},
        options);
    EXPECT_EQ(byteAt(set.draw(0), 0, 0), 153);
}

TEST(LastingFills, SeeTheCameraOfTheirStep) {
    TextScene moving(eyeScene("4 + time") +
                     "Step 1\nFill a with Eye\nEndStep\nClear b\nFill window with Show\n");
    EXPECT_EQ(byteAt(moving.draw(0), 0, 0), 0);
    EXPECT_EQ(byteAt(moving.draw(1.5), 0, 0), 102) << "tick 0 is at time 0";
    EXPECT_EQ(byteAt(moving.draw(3.5), 0, 0), 153) << "tick 2";
    expectStored(byteAt(moving.draw(2), 0, 0), 127.5);  // going back
    TextScene still(eyeScene("5") + "Step 1\nFill a with Eye\nEndStep\nClear b\nFill window with Show\n");
    expectStored(byteAt(still.draw(1), 0, 0), 127.5);
}

TEST(LastingFills, ThatDoNotReadTheCameraDoNotFollowIt) {
    const SceneFolder folder(eyeScene("4 + time") +
                             "Once\nFill b with Plain\nEndOnce\nStep 1\nFill b with Add\nEndStep\n"
                             "Pass a\nEndPass\nFill window with Show\n");
    render::Stats stats;
    auto loaded = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", {}, stats);
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    const auto steps = [&] {
        for (const auto& each : stats.counts)
            if (each.name == "steps") return each.value;
        return std::uint64_t{0};
    };
    ASSERT_TRUE(loaded->draw(1, stats));
    const auto picture = loaded->draw(3, stats);
    ASSERT_TRUE(picture);
    EXPECT_EQ(byteAt(*picture, 3, 0), 204) << ".2 and three times .2";
    EXPECT_EQ(steps(), 3U) << "nothing began anew";
}

}  // namespace
}  // namespace glibra::test
