#include "gpu/object/buffer.h"

#include <cstring>

#include "fixture.h"
#include "gpu/format/gl_names.h"
#include "gpu/object/timer.h"

namespace glibra::gpu {
namespace {

using test::Rgba;

class VertexArrayTest : public test::GpuTest {
  protected:
    /// Draws one point whose colour the vertex stage computes from its inputs.
    static Rgba point(const Program& program, const VertexArray& vertices, int first = 0,
                      const void* indices = nullptr) {
        const auto target = Target::window(driver(), 1, 1, TexelFormat::rgba32f);
        EXPECT_TRUE(target);
        target->bind();
        target->clearColor(0, {-1, -1, -1, -1});
        vertices.bind();
        program.use();
        if (indices)
            glDrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, indices);
        else
            glDrawArrays(GL_POINTS, first, 1);
        return test::pixels(context(), *target).at(0);
    }
    static std::optional<Program> reading(const std::string& inputs, const std::string& color) {
        return build(
            "#version 410 core\n" + inputs + "flat out vec4 vColor;\nvoid main() { vColor = " + color +
                "; gl_Position = vec4(0, 0, 0, 1); }",
            "#version 410 core\nflat in vec4 vColor;\nout vec4 fColor;\nvoid main() { fColor = vColor; }");
    }
};

TEST_F(VertexArrayTest, PackedAndInterleavedBuffersAreReadAsDescribed) {
    const auto program =
        reading("layout(location = 0) in vec2 aPlace;\nlayout(location = 3) in vec2 aOther;\n",
                "vec4(aPlace, aOther)");
    ASSERT_TRUE(program);
    const std::array<float, 8> packed{1, 2, 3, 4, 5, 6, 7, 8};
    const std::array<float, 12> interleaved{9, 9, 9, 10, 11, 9, 9, 12, 13, 9, 9, 9};
    const auto first = Buffer::create(std::as_bytes(std::span(packed)));
    const auto second = Buffer::create(std::as_bytes(std::span(interleaved)));
    ASSERT_TRUE(first && second);
    const std::array<AttributeSource, 2> sources{
        {{.buffer = &*first, .location = 0, .components = 2},
         {.buffer = &*second, .location = 3, .components = 2, .offset = 12, .stride = 16}}};
    const VertexArray vertices(sources);
    EXPECT_EQ(point(*program, vertices, 0), (Rgba{1, 2, 10, 11}));
    EXPECT_EQ(point(*program, vertices, 1), (Rgba{3, 4, 12, 13}));
}

TEST_F(VertexArrayTest, MissingComponentsReadZeroAndOne) {
    const auto program = reading("layout(location = 0) in vec4 aValue;\n", "aValue");
    ASSERT_TRUE(program);
    const std::array<float, 1> one{5};
    const auto buffer = Buffer::create(std::as_bytes(std::span(one)));
    ASSERT_TRUE(buffer);
    const std::array<AttributeSource, 1> sources{{{.buffer = &*buffer, .location = 0, .components = 1}}};
    EXPECT_EQ(point(*program, VertexArray(sources)), (Rgba{5, 0, 0, 1}));
}

TEST_F(VertexArrayTest, IntegersStayIntegers) {
    const auto program =
        reading("layout(location = 0) in ivec2 aSigned;\nlayout(location = 1) in uvec2 aUnsigned;\n",
                "vec4(aSigned.x / 2, aSigned.y, aUnsigned.x / 3u, aUnsigned.y)");
    ASSERT_TRUE(program);
    const std::array<std::int32_t, 2> numbers{7, -5};
    const std::array<std::uint32_t, 2> counts{11, 4000000000U};
    const auto first = Buffer::create(std::as_bytes(std::span(numbers)));
    const auto second = Buffer::create(std::as_bytes(std::span(counts)));
    ASSERT_TRUE(first && second);
    const std::array<AttributeSource, 2> sources{
        {{.buffer = &*first, .location = 0, .components = 2, .type = AttributeSource::Type::integer},
         {.buffer = &*second,
          .location = 1,
          .components = 2,
          .type = AttributeSource::Type::unsignedInteger}}};
    EXPECT_EQ(point(*program, VertexArray(sources)), (Rgba{3, -5, 3, 4e9F}));
}

TEST_F(VertexArrayTest, IndicesChooseTheVertex) {
    const auto program = reading("layout(location = 0) in float aValue;\n", "vec4(aValue)");
    ASSERT_TRUE(program);
    const std::array<float, 3> values{10, 20, 30};
    const std::array<std::uint32_t, 2> order{2, 1};
    const auto buffer = Buffer::create(std::as_bytes(std::span(values)));
    const auto indices = Buffer::create(std::as_bytes(std::span(order)));
    ASSERT_TRUE(buffer && indices);
    const std::array<AttributeSource, 1> sources{{{.buffer = &*buffer, .location = 0, .components = 1}}};
    const VertexArray vertices(sources, &*indices);
    EXPECT_EQ(point(*program, vertices, 0, reinterpret_cast<const void*>(4))[0], 20.F);
}

TEST_F(VertexArrayTest, ConstantsReachInputsOfEveryKind) {
    struct Case {
        const char* type;
        const char* color;
        GLenum glType;
        std::array<double, 4> value;
        Rgba expected;
    };
    const VertexArray nothing({});
    for (const Case& each : {
             Case{"vec4", "aValue", GL_FLOAT_VEC4, {1, .5, 0, .25}, {1, .5F, 0, .25F}},
             Case{"vec2", "vec4(aValue, 7, 7)", GL_FLOAT_VEC2, {3, 4, 5, 6}, {3, 4, 7, 7}},
             Case{"float", "vec4(aValue)", GL_FLOAT, {3, 0, 0, 1}, {3, 3, 3, 3}},
             Case{"int", "vec4(aValue / 2)", GL_INT, {-7, 0, 0, 1}, {-3, -3, -3, -3}},
             Case{"uvec2", "vec4(aValue, 1, 1)", GL_UNSIGNED_INT_VEC2, {3e9, 5, 0, 1}, {3e9F, 5, 1, 1}},
             Case{"dvec2", "vec4(aValue, 1, 1)", GL_DOUBLE_VEC2, {.75, -2, 0, 1}, {.75F, -2, 1, 1}},
             Case{"mat2", "vec4(aValue[0], aValue[1])", GL_FLOAT_MAT2, {8, 9, 0, 1}, {8, 9, 8, 9}},
         }) {
        const auto program =
            reading(std::string("layout(location = 2) in ") + each.type + " aValue;\n", each.color);
        ASSERT_TRUE(program) << each.type;
        setConstantAttribute(2, valueType(each.glType), each.value);
        EXPECT_EQ(point(*program, nothing), each.expected) << each.type;
    }
}

TEST_F(VertexArrayTest, BuffersCanBeOverwrittenInPartAndNeverBeyond) {
    const std::array<std::uint32_t, 4> before{1, 2, 3, 4};
    auto buffer = Buffer::create(std::as_bytes(std::span(before)), GL_DYNAMIC_DRAW);
    ASSERT_TRUE(buffer);
    EXPECT_EQ(buffer->size(), 16U);
    const std::array<std::uint32_t, 3> change{30, 40, 50};
    buffer->update(8, std::as_bytes(std::span(change)));
    buffer->update(16, std::as_bytes(std::span(change)));
    std::array<std::uint32_t, 4> after{};
    buffer->bind(GL_COPY_READ_BUFFER);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, 16, after.data());
    EXPECT_EQ(after, (std::array<std::uint32_t, 4>{1, 2, 30, 40}));
}

TEST_F(VertexArrayTest, ABufferTooLargeForAnythingIsAnError) {
    const auto buffer = Buffer::create(std::size_t{1} << 62);
    ASSERT_FALSE(buffer);
    EXPECT_TRUE(buffer.diagnostics.at(0).id == "draw-E05" || buffer.diagnostics[0].id == "gpu-E02");
    (void)context().debugLog().take();
}

TEST_F(VertexArrayTest, MovingHandsTheNameOn) {
    const std::array<float, 1> one{5};
    auto made = Buffer::create(std::as_bytes(std::span(one)));
    ASSERT_TRUE(made);
    const GLuint id = made->id();
    {
        Buffer second = std::move(*made);
        EXPECT_EQ(second.id(), id);
        Buffer third;
        third = std::move(second);
        EXPECT_EQ(third.id(), id);
        EXPECT_TRUE(glIsBuffer(id));
    }
    EXPECT_FALSE(glIsBuffer(id));
}

TEST_F(VertexArrayTest, ATimerMeasuresSomething) {
    const auto program = build(test::kCoverAll, R"(#version 410 core
out vec4 fColor;
void main() {
    float sum = 0.;
    for (int i = 0; i < 400; ++i) sum += sin(float(i) + gl_FragCoord.x);
    fColor = vec4(sum);
}
)");
    ASSERT_TRUE(program);
    const Query timer(GL_TIME_ELAPSED);
    timer.begin();
    (void)shade(*program, 64, 64);
    timer.end();
    EXPECT_GT(timer.result(), 0U);
    EXPECT_TRUE(timer.isReady());
}

}  // namespace
}  // namespace glibra::gpu
