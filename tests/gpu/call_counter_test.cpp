// Compares counted calls with calls made by hand.

#include "gpu/context/call_counter.h"

#include <vector>

#include "fixture.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {
namespace {

class CallCounterTest : public test::GpuTest {};

TEST_F(CallCounterTest, EveryCallIsCountedWhileItLivesAndNoOther) {
    std::uint64_t calls = 0;
    {
        const CallCounter counter;
        EXPECT_TRUE(isCounting());
        glClearColor(0, 0, 0, 0);
        glEnable(GL_DEPTH_TEST);
        glGetError();
        calls = counter.counts().calls;
    }
    EXPECT_EQ(calls, 3U);
    EXPECT_FALSE(isCounting());
    glDisable(GL_DEPTH_TEST);
    const CallCounter later;
    EXPECT_EQ(later.counts().calls, 0U);
}

TEST_F(CallCounterTest, AnInnerOneTakesTheCallsOfTheOuter) {
    const CallCounter outer;
    glGetError();
    {
        const CallCounter inner;
        glGetError();
        glGetError();
        EXPECT_EQ(inner.counts().calls, 2U);
    }
    glGetError();
    EXPECT_EQ(outer.counts().calls, 2U);
}

TEST_F(CallCounterTest, BytesOfBuffersAndTexturesAreThoseGiven) {
    const std::vector<std::byte> bytes(1000);
    const CallCounter counter;
    auto buffer = Buffer::create(bytes);
    ASSERT_TRUE(buffer);
    EXPECT_EQ(counter.counts().bytesUploaded, 1000U);
    EXPECT_EQ(counter.counts().buffersFilled, 1U);
    buffer->update(100, std::span(bytes).first(50));
    EXPECT_EQ(counter.counts().bytesUploaded, 1050U);
    ASSERT_TRUE(Buffer::create(std::size_t{1} << 20));
    EXPECT_EQ(counter.counts().bytesUploaded, 1050U) << "a buffer without content";

    const std::vector<std::byte> texels(4 * 3 * 2 * 3 * 2);
    ASSERT_TRUE(Texture::create(driver(), TextureShape::texture3D, TexelFormat::rgba16, {4, 3, 2},
                                {texels, 3, TexelType::u16}));
    EXPECT_EQ(counter.counts().bytesUploaded, 1050U + 144U);
    const std::vector<std::byte> faces(6 * 4 * 4 * 16);
    ASSERT_TRUE(Texture::create(driver(), TextureShape::cube, TexelFormat::rgba32f, {4, 4, 1},
                                {faces, 4, TexelType::f32}));
    EXPECT_EQ(counter.counts().bytesUploaded, 1050U + 144U + 1536U);
    EXPECT_EQ(counter.counts().texturesFilled, 7U);
    const std::vector<std::byte> line(5);
    ASSERT_TRUE(Texture::create(driver(), TextureShape::texture1D, TexelFormat::rgba8, {5, 1, 1},
                                {line, 1, TexelType::u8}));
    EXPECT_EQ(counter.counts().bytesUploaded, 1050U + 144U + 1536U + 5U);
}

TEST_F(CallCounterTest, ProgramsDrawsAndPixelsAreCounted) {
    const CallCounter counter;
    const auto program =
        build(test::kCoverAll, "#version 410 core\nout vec4 c;\nvoid main() { c = vec4(1.); }\n");
    ASSERT_TRUE(program);
    EXPECT_EQ(counter.counts().programsLinked, 1U);
    shade(*program, 7, 3);
    EXPECT_EQ(counter.counts().draws, 1U);
    EXPECT_EQ(counter.counts().pixelsRead, 21U);
}

}  // namespace
}  // namespace glibra::gpu
