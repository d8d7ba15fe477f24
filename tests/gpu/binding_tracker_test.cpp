// Bindings that are made are not made again.

#include "gpu/state/state_tracker.h"

#include "fixture.h"
#include "gpu/context/call_counter.h"

namespace glibra::gpu {
namespace {

class BindingTrackerTest : public test::GpuTest {
  protected:
    static Texture texture(TextureShape shape = TextureShape::texture2D) {
        Result<Texture> made = Texture::create(driver(), shape, TexelFormat::rgba8, {4, 4, 1});
        EXPECT_TRUE(made);
        return std::move(*made);
    }
    static GLuint bound(GLenum name) {
        GLint found = 0;
        glGetIntegerv(name, &found);
        return static_cast<GLuint>(found);
    }
};

TEST_F(BindingTrackerTest, BindsWhatIsNotBound) {
    const Texture a = texture(), b = texture(), cube = texture(TextureShape::cube);
    const Sampler sampler;
    BindingTracker tracker;
    const auto calls = [](auto&& action) {
        const CallCounter counter;
        action();
        return counter.counts().calls;
    };
    EXPECT_EQ(calls([&] { tracker.bind(a, 2); }), 2U) << "unit, texture";
    EXPECT_EQ(calls([&] { tracker.bind(a, 2); }), 0U);
    EXPECT_EQ(calls([&] { tracker.bind(cube, 2); }), 2U) << "a unit has one texture of each shape";
    EXPECT_EQ(calls([&] { tracker.bind(a, 2); }), 0U);
    EXPECT_EQ(calls([&] { tracker.bind(b, 2); }), 2U);
    EXPECT_EQ(bound(GL_TEXTURE_BINDING_2D), b.id());
    EXPECT_EQ(calls([&] { tracker.bind(b, 3); }), 2U);
    EXPECT_EQ(calls([&] { tracker.bind(sampler, 3); }), 1U);
    EXPECT_EQ(calls([&] { tracker.bind(sampler, 3); }), 0U);
    tracker.forget();
    EXPECT_EQ(calls([&] { tracker.bind(b, 3); }), 2U);
    EXPECT_EQ(calls([&] { tracker.bind(sampler, 3); }), 1U);
}

TEST_F(BindingTrackerTest, WorkOnTexturesIsForgotten) {
    const Texture a = texture();
    BindingTracker tracker;
    tracker.bind(a, 0);
    const Texture other = texture();
    EXPECT_EQ(bound(GL_TEXTURE_BINDING_2D), other.id());
    tracker.forgetWorkUnit();
    tracker.bind(a, 0);
    EXPECT_EQ(bound(GL_TEXTURE_BINDING_2D), a.id());
}

TEST_F(BindingTrackerTest, BuffersAreBoundPerTargetAndIndex) {
    const std::array<std::byte, 16> bytes{};
    const Result<Buffer> a = Buffer::create(bytes), b = Buffer::create(bytes);
    ASSERT_TRUE(a && b);
    BindingTracker tracker;
    const auto calls = [&](const Buffer& buffer, GLuint index) {
        const CallCounter counter;
        tracker.bindBase(buffer, GL_UNIFORM_BUFFER, index);
        return counter.counts().calls;
    };
    EXPECT_EQ(calls(*a, 0), 1U);
    EXPECT_EQ(calls(*b, 1), 1U);
    EXPECT_EQ(calls(*a, 0), 0U);
    EXPECT_EQ(calls(*b, 0), 1U);
    EXPECT_EQ(calls(*b, 1), 0U);
    tracker.forgetBuffers();
    EXPECT_EQ(calls(*b, 1), 1U);
}

}  // namespace
}  // namespace glibra::gpu
