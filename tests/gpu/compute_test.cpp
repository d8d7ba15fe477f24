// Compute programs, their buffers and images, and queries.

#include "gpu/object/program.h"

#include <algorithm>
#include <cstring>

#include "fixture.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"
#include "gpu/object/timer.h"

namespace glibra::gpu {
namespace {

class ComputeTest : public test::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (!driver().compute) GTEST_SKIP() << "needs GL 4.3";
    }
    static std::optional<Program> compute(std::string_view text) {
        const std::array<StageSource, 1> stages{{{GL_COMPUTE_SHADER, text}}};
        BuildOutcome outcome = buildProgram(driver(), {.stages = stages});
        EXPECT_TRUE(outcome.program) << outcome.linkLog << outcome.stages.at(0).log;
        return std::move(outcome.program);
    }
    static Buffer bufferOf(const std::vector<std::uint32_t>& values) {
        auto buffer = Buffer::create(std::as_bytes(std::span(values)), GL_DYNAMIC_COPY);
        EXPECT_TRUE(buffer);
        return std::move(*buffer);
    }
    static std::vector<std::uint32_t> content(const Buffer& buffer) {
        std::vector<std::uint32_t> values(buffer.size() / 4);
        buffer.read(0, std::as_writable_bytes(std::span(values)));
        return values;
    }
};

constexpr const char* kDouble = R"(#version 430 core
layout(local_size_x = 4) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
void main() {
    if (gl_GlobalInvocationID.x < values.length()) values[gl_GlobalInvocationID.x] *= 2u;
}
)";

TEST_F(ComputeTest, EveryInvocationRuns) {
    const auto program = compute(kDouble);
    ASSERT_TRUE(program);
    EXPECT_EQ(program->localSize(), (std::array<int, 3>{4, 1, 1}));
    const Buffer buffer = bufferOf({10, 12, 16, 18, 50, 17});
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    program->use();
    dispatch({2, 1, 1});
    finishShaderWrites();
    EXPECT_EQ(content(buffer), (std::vector<std::uint32_t>{20, 24, 32, 36, 100, 34}));
}

TEST_F(ComputeTest, StoresComeAfterTheClearBeforeThem) {
    auto texture = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {64, 64, 1});
    ASSERT_TRUE(texture);
    const std::array<const Texture*, 1> colors{&*texture};
    const Result<Target> target = Target::textures(driver(), colors);
    ASSERT_TRUE(target);
    // Each round has a program of its own: whether one was compiled before decides on zink.
    for (int round = 0; round < 4; ++round) {
        const auto program = compute(R"(#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8, binding = 0) writeonly uniform image2D uImage;
void main() { imageStore(uImage, ivec2(gl_GlobalInvocationID.xy), vec4(0, 0, 1, 1)); }
)");
        ASSERT_TRUE(program);
        target->bind();
        target->clearColor(0, {1, 0, 0, 1});
        settleClears(driver());
        texture->bindImage(0, 0, {}, GL_WRITE_ONLY);
        program->use();
        dispatch({8, 8, 1});
        finishShaderWrites();
        const auto pixels = readPixels(driver(), target->readable(), 0, {0, 0, 64, 64}, {1, TexelType::u8});
        ASSERT_TRUE(pixels);
        EXPECT_EQ(std::count(pixels->begin(), pixels->end(), std::byte{0}), 64 * 64) << round;
    }
}

TEST_F(ComputeTest, BuffersOfAnySizeAreCleared) {
    for (const bool isSoftware : {true, false}) {
        Capabilities capabilities = driver();
        capabilities.isSoftware = isSoftware;
        for (std::size_t bytes = 1; bytes < 70; ++bytes) {
            auto buffer = Buffer::create(std::vector<std::byte>(bytes, std::byte{7}), GL_DYNAMIC_COPY);
            ASSERT_TRUE(buffer);
            buffer->clear(capabilities);
            std::vector<std::byte> content(bytes, std::byte{9});
            buffer->read(0, content);
            EXPECT_EQ(content, std::vector<std::byte>(bytes)) << bytes;
        }
    }
}

TEST_F(ComputeTest, GroupsAreRoundedUp) {
    EXPECT_EQ(groupsOver({512, 512, 1}, {8, 8, 1}), (std::array<std::uint64_t, 3>{64, 64, 1}));
    EXPECT_EQ(groupsOver({513, 1, 0}, {8, 8, 1}), (std::array<std::uint64_t, 3>{65, 1, 0}));
    EXPECT_EQ(groupsOver({0xffffffffU, 1, 1}, {2, 1, 1}), (std::array<std::uint64_t, 3>{0x80000000U, 1, 1}));
}

TEST_F(ComputeTest, AShaderClearsBuffersOfAnySizeAndLeavesTheState) {
    BufferClearer clearer;
    const std::optional<Program> program = compute(kDouble);
    for (const std::size_t bytes :
         {std::size_t{1}, std::size_t{15}, std::size_t{16}, std::size_t{4099}, std::size_t{(3 << 20) + 7}}) {
        Result<Buffer> buffer = Buffer::create(std::vector<std::byte>(bytes, std::byte{0xa5}));
        Result<Buffer> other = Buffer::create(16);
        ASSERT_TRUE(buffer && other);
        program->use();
        other->bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        ASSERT_TRUE(clearer.clearByShader(driver(), *buffer));
        GLint used = 0, bound = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &used);
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &bound);
        EXPECT_EQ(used, static_cast<GLint>(program->id()));
        EXPECT_EQ(bound, static_cast<GLint>(other->id()));
        std::vector<std::byte> content(bytes, std::byte{1});
        buffer->read(0, content);
        EXPECT_EQ(content, std::vector<std::byte>(bytes)) << bytes;
    }
    // A program that is deleted lives only as long as it is used.
    {
        const std::optional<Program> deleted = compute(kDouble);
        deleted->use();
    }
    Buffer words = bufferOf({1, 2, 3, 4});
    ASSERT_TRUE(clearer.clearByShader(driver(), words));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    GLint used = -1;
    glGetIntegerv(GL_CURRENT_PROGRAM, &used);
    EXPECT_EQ(used, 0);
    Capabilities small = driver();
    small.maxStorageBlockBytes = 16;
    Result<Buffer> buffer = Buffer::create(std::vector<std::byte>(17, std::byte{3}));
    EXPECT_FALSE(clearer.clearByShader(small, *buffer));
    clearer.clear(small, *buffer);
    std::vector<std::byte> content(17, std::byte{1});
    buffer->read(0, content);
    EXPECT_EQ(content, std::vector<std::byte>(17));
}

TEST_F(ComputeTest, GroupCountsComeFromABuffer) {
    const auto program = compute(kDouble);
    ASSERT_TRUE(program);
    const Buffer buffer = bufferOf(std::vector<std::uint32_t>(12, 1));
    const Buffer groups = bufferOf({99, 2, 1, 1});
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    program->use();
    dispatchFrom(groups, 4);
    finishShaderWrites();
    EXPECT_EQ(content(buffer), (std::vector<std::uint32_t>{2, 2, 2, 2, 2, 2, 2, 2, 1, 1, 1, 1}));
}

TEST_F(ComputeTest, AtomicCountersCount) {
    const auto program = compute(R"(#version 430 core
layout(local_size_x = 8, local_size_y = 2) in;
layout(binding = 0, offset = 4) uniform atomic_uint uCount;
void main() { atomicCounterIncrement(uCount); }
)");
    ASSERT_TRUE(program);
    const Buffer counters = bufferOf({7, 0});
    counters.bindBase(GL_ATOMIC_COUNTER_BUFFER, 0);
    program->use();
    dispatch({3, 5, 1});
    finishShaderWrites();
    EXPECT_EQ(content(counters), (std::vector<std::uint32_t>{7, 3 * 5 * 16}));
}

TEST_F(ComputeTest, ImagesAreStoredByLevelAndLayer) {
    auto texture = Texture::create(driver(), {TextureShape::array2D, TexelFormat::r32ui, {4, 4, 3}, 2});
    ASSERT_TRUE(texture);
    const auto program = compute(R"(#version 430 core
layout(local_size_x = 1) in;
layout(r32ui, binding = 0) uniform writeonly uimage2D uOut;
void main() { imageStore(uOut, ivec2(gl_GlobalInvocationID.xy), uvec4(7u)); }
)");
    ASSERT_TRUE(program);
    texture->bindImage(0, 1, 2, GL_WRITE_ONLY);
    program->use();
    dispatch({2, 2, 1});
    finishShaderWrites();
    const auto bytes = texture->read(1, 1, TexelType::u32);
    ASSERT_TRUE(bytes);
    std::vector<std::uint32_t> values(bytes->size() / 4);
    std::memcpy(values.data(), bytes->data(), bytes->size());
    EXPECT_EQ(values, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 7, 7, 7, 7}));
}

TEST_F(ComputeTest, BuffersAreClearedAndCopied) {
    Buffer buffer = bufferOf({1, 2, 3});
    Buffer copy = bufferOf({0, 0, 0, 9});
    copy.copyFrom(buffer);
    EXPECT_EQ(content(copy), (std::vector<std::uint32_t>{1, 2, 3, 9}));
    Capabilities old = driver();
    old.minor = 1;
    const std::array<std::uint32_t, 3> values{4, 5, 6};
    for (const Capabilities& driver : {GpuTest::driver(), old}) {
        buffer.update(0, std::as_bytes(std::span(values)));
        buffer.clear(driver);
        EXPECT_EQ(content(buffer), std::vector<std::uint32_t>(3, 0));
    }
}

TEST_F(ComputeTest, TheLimitsMeetTheMinimaOfOpenGl43) {
    const Capabilities& limits = driver();
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_GE(limits.maxComputeGroups[axis], 65535);
    EXPECT_GE(limits.maxComputeLocalSize[0], 1024);
    EXPECT_GE(limits.maxComputeInvocations, 1024);
    EXPECT_GE(limits.maxComputeSharedBytes, 32768);
    EXPECT_GE(limits.maxStorageBlockBytes, 1 << 24);
    EXPECT_GE(limits.maxStorageBufferBindings, 8);
    EXPECT_GE(limits.maxAtomicCounterBindings, 1);
    EXPECT_GE(limits.maxArrayLayers, 2048);
}

class QueryTest : public test::GpuTest {};

TEST_F(QueryTest, CountsPrimitivesAndSamples) {
    const auto program =
        build(test::kCoverAll, "#version 410 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n");
    ASSERT_TRUE(program);
    const Query primitives(GL_PRIMITIVES_GENERATED), samples(GL_SAMPLES_PASSED);
    primitives.begin();
    samples.begin();
    shade(*program, 30, 30);
    samples.end();
    primitives.end();
    EXPECT_EQ(primitives.result(), 1U);
    EXPECT_EQ(samples.result(), 900U);
}

}  // namespace
}  // namespace glibra::gpu
