// Pictures and textures that stay on the device, in a context of the calling program.

#include <glad/gl.h>
#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace glibra {
namespace {

/// The left half is another colour than the right one, the top another than the bottom, and the corner is
/// half transparent.
constexpr const char* kQuarters = R"(WindowSize 8 6
Texture2D seen 4 4 rgba8 generate
Texture2D unseen 4 4 rgba8
Fragment inline
#version 330
in vec2 vST;
out vec4 color;
void main() { color = vec4(step(.5, vST), .2, vST.s < .5 ? .5 : 1.); }
EndFragment
Program Paint
Fill seen with Paint
Fragment inline
#version 330
uniform sampler2D seen;
in vec2 vST;
out vec4 color;
void main() { color = texture(seen, vST); }
EndFragment
Program Show
Fill window with Show
)";

class DeviceTest : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(owner) << owner.message();
        guest = Renderer::open(Renderer::current());
        ASSERT_TRUE(guest) << guest.message();
        scene = guest->loadText(kQuarters);
        ASSERT_TRUE(scene) << scene.message();
    }
    Result<Renderer> owner = Renderer::open();
    Result<Renderer> guest;
    Result<Scene> scene;
};

/// A framebuffer of the calling program with one texture or renderbuffer of a size.
struct Canvas {
    Canvas(int columns, int rows, GLenum format, int samples = 0) : width(columns), height(rows) {
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        if (samples > 0) {
            glGenRenderbuffers(1, &renderbuffer);
            glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
        } else {
            glGenTextures(1, &texture);
            glBindTexture(GL_TEXTURE_2D, texture);
            const bool isInteger = format == GL_RGBA8UI;
            glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0,
                         isInteger ? GL_RGBA_INTEGER : GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        }
        glClearColor(.2F, .2F, .2F, .2F);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
    ~Canvas() {
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteTextures(1, &texture);
        glDeleteRenderbuffers(1, &renderbuffer);
    }
    /// The bytes, the bottom row first.
    [[nodiscard]] std::vector<std::byte> bytes() const {
        std::vector<std::byte> all(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return all;
    }
    int width, height;
    GLuint framebuffer = 0, texture = 0, renderbuffer = 0;
};

/// The picture in a canvas that was cleared to 51, at its lower left pixel.
std::vector<std::byte> expectedIn(const Canvas& canvas, const Picture& picture, int x, int y) {
    std::vector<std::byte> all(
        static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height) * 4, std::byte{51});
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const int toX = x + column, toY = y + row;
            if (toX < 0 || toX >= canvas.width || toY < 0 || toY >= canvas.height) continue;
            for (int i = 0; i < 4; ++i)
                all[static_cast<std::size_t>((toY * canvas.width + toX) * 4 + i)] =
                    i < picture.components
                        ? picture.data[static_cast<std::size_t>(
                              ((picture.height - 1 - row) * picture.width + column) * picture.components + i)]
                        : std::byte{255};
        }
    return all;
}

TEST_F(DeviceTest, DrawsIntoARectangleOfAFramebuffer) {
    const Canvas canvas(20, 16, GL_RGBA8);
    for (const bool alpha : {false, true}) {
        const auto picture = scene->draw({.width = 8, .height = 6, .alpha = alpha});
        ASSERT_TRUE(picture) << picture.message();
        for (const auto& [x, y] : {std::array{0, 0}, {5, 3}, {-3, -2}, {15, 12}, {40, 40}}) {
            glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
            glDisable(GL_SCISSOR_TEST);
            glColorMask(1, 1, 1, 1);
            glClearColor(.2F, .2F, .2F, .2F);
            glClear(GL_COLOR_BUFFER_BIT);
            glEnable(GL_SCISSOR_TEST);  // what a program may have set
            glScissor(0, 0, 2, 2);
            glColorMask(0, 1, 0, 0);
            const auto drawn =
                scene->drawInto({.framebuffer = canvas.framebuffer, .x = x, .y = y}, {.alpha = alpha});
            ASSERT_TRUE(drawn) << drawn.message();
            EXPECT_EQ(canvas.bytes(), expectedIn(canvas, *picture, x, y)) << x << " " << y << " " << alpha;
        }
    }
}

TEST_F(DeviceTest, DrawsIntoATextureInItsSize) {
    const Canvas canvas(13, 9, GL_RGBA8);
    ASSERT_TRUE(scene->drawInto({.texture = canvas.texture}));
    const auto picture = scene->draw({.width = 13, .height = 9});
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(canvas.bytes(), expectedIn(canvas, *picture, 0, 0));
    ASSERT_TRUE(scene->drawInto({.texture = canvas.texture, .x = 1, .y = 2, .width = 4, .height = 5}));
    EXPECT_EQ(scene->target("window")->width, 4);
    EXPECT_EQ(scene->target("window")->height, 5);
}

TEST_F(DeviceTest, KeepsTheBytesInOtherFormats) {
    const auto picture = scene->draw({.width = 8, .height = 6});
    ASSERT_TRUE(picture) << picture.message();
    for (const GLenum format : std::array<GLenum, 3>{GL_RGBA16F, GL_RGBA32F, GL_SRGB8_ALPHA8}) {
        const Canvas canvas(8, 6, format);
        glEnable(GL_FRAMEBUFFER_SRGB);
        ASSERT_TRUE(scene->drawInto({.framebuffer = canvas.framebuffer}));
        EXPECT_EQ(canvas.bytes(), expectedIn(canvas, *picture, 0, 0)) << format;
    }
}

TEST_F(DeviceTest, FillsAllSamplesOfAFramebuffer) {
    const Canvas samples(8, 6, GL_RGBA8, 4), canvas(8, 6, GL_RGBA8);
    ASSERT_TRUE(scene->drawInto({.framebuffer = samples.framebuffer}, {.samples = 4}));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, canvas.framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBlitFramebuffer(0, 0, 8, 6, 0, 0, 8, 6, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    const auto picture = scene->draw({.width = 8, .height = 6, .samples = 4});
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(canvas.bytes(), expectedIn(canvas, *picture, 0, 0));
}

TEST_F(DeviceTest, RefusesWhatTakesNoPicture) {
    const Canvas integers(8, 6, GL_RGBA8UI), silent(8, 6, GL_RGBA8), empty(8, 6, GL_RGBA8);
    glBindFramebuffer(GL_FRAMEBUFFER, silent.framebuffer);
    glDrawBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, empty.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    GLuint volume = 0, bare = 0;
    glGenTextures(1, &volume);
    glBindTexture(GL_TEXTURE_3D, volume);
    glGenTextures(1, &bare);
    glBindTexture(GL_TEXTURE_2D, bare);
    const struct {
        Surface surface;
        const char* says;
    } wrong[] = {
        {{}, "window"},
        {{.framebuffer = 4711}, "has no framebuffer 4711"},
        {{.framebuffer = integers.framebuffer}, "integers"},
        {{.framebuffer = silent.framebuffer}, "no colour"},
        {{.framebuffer = empty.framebuffer}, "not complete"},
        {{.texture = 4711}, "has no texture 4711"},
        {{.texture = integers.texture}, "integers"},
        {{.texture = volume}, "not a GL_TEXTURE_2D"},
        {{.texture = bare}, "no level 0"},
    };
    for (const auto& [surface, says] : wrong) {
        const Result<void> drawn = scene->drawInto(surface);
        ASSERT_FALSE(drawn) << says;
        EXPECT_EQ(drawn.diagnostics().front().id, "library-E08") << drawn.message();
        EXPECT_NE(drawn.message().find(says), std::string::npos) << drawn.message();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << says;
    }
    const Canvas canvas(8, 6, GL_RGBA8);
    for (const Result<void>& each :
         {scene->drawInto({.framebuffer = canvas.framebuffer, .width = -1}),
          scene->drawInto({.framebuffer = canvas.framebuffer, .height = 1 << 20}),
          scene->drawInto({.framebuffer = canvas.framebuffer, .width = 4}, {.width = 5}),
          scene->drawInto({.texture = canvas.texture}, {.height = 5})}) {
        ASSERT_FALSE(each);
        EXPECT_EQ(each.diagnostics().front().id, "library-E01") << each.message();
    }
    EXPECT_TRUE(scene->drawInto({.framebuffer = canvas.framebuffer}));
}

TEST_F(DeviceTest, NeedsTheContextOfTheProgram) {
    Result<Scene> own = owner->loadText(kQuarters);
    ASSERT_TRUE(own) << own.message();
    ASSERT_TRUE(own->draw());
    EXPECT_EQ(own->drawInto({.framebuffer = 1}).diagnostics().front().id, "library-E08");
    EXPECT_EQ(own->deviceTexture("seen").diagnostics().front().id, "library-E08");
}

TEST_F(DeviceTest, GivesTexturesByTheirNames) {
    EXPECT_EQ(scene->deviceTexture("seen").diagnostics().front().id, "library-E04");
    ASSERT_TRUE(scene->draw());
    const auto texture = scene->deviceTexture("seen");
    ASSERT_TRUE(texture) << texture.message();
    EXPECT_EQ(texture->target, static_cast<std::uint32_t>(GL_TEXTURE_2D));
    EXPECT_EQ(texture->format, static_cast<std::uint32_t>(GL_RGBA8));
    EXPECT_EQ(texture->width, 4);
    EXPECT_EQ(texture->height, 4);
    EXPECT_EQ(texture->levels, 3);
    for (int level = 0; level < texture->levels; ++level) {
        const std::string name = "seen.level(" + std::to_string(level) + ")";
        const auto expected = scene->target(name);
        ASSERT_TRUE(expected) << expected.message();
        std::vector<std::byte> bottomFirst(expected->data.size()), topFirst;
        glBindTexture(GL_TEXTURE_2D, texture->name);
        glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, bottomFirst.data());
        const auto rowBytes = static_cast<std::ptrdiff_t>(expected->width) * 4;
        for (auto row = bottomFirst.end(); row != bottomFirst.begin(); row -= rowBytes)
            topFirst.insert(topFirst.end(), row - rowBytes, row);
        EXPECT_EQ(topFirst, expected->data) << name;
    }
    ASSERT_TRUE(scene->draw({.time = 1}));
    EXPECT_EQ(scene->deviceTexture("seen")->name, texture->name);
    EXPECT_EQ(scene->deviceTexture("unseen").diagnostics().front().id, "library-E07");
    EXPECT_EQ(scene->deviceTexture("sen").diagnostics().front().id, "library-E02");
    EXPECT_EQ(scene->deviceTexture("seen.level(1)").diagnostics().front().id, "library-E02");
}

}  // namespace
}  // namespace glibra
