#include "gpu/object/loop_limit.h"

#include <fmt/format.h>

#include "fixture.h"

namespace glibra::gpu {
namespace {

class LoopLimitTest : public test::GpuTest {};

TEST_F(LoopLimitTest, IsWhereLoopsOfAnotherShapeEndToo) {
    const int limit = measureLoopLimit(context());
    ASSERT_GE(limit, 0);
    // Two loops, one with a condition that the compiler cannot evaluate.
    const std::optional<Program> program =
        build(test::kCoverAll,
              "#version 410 core\nuniform int uFirst, uSecond;\nout vec4 fColor;\nvoid main() {\n"
              "  int a = 0, b = 0;\n  while (a < uFirst) ++a;\n  for (int i = uSecond; i > 0; --i) ++b;\n"
              "  fColor = vec4(a, b, 0., 1.);\n}\n");
    ASSERT_TRUE(program);
    program->use();
    const auto counted = [&](int first, int second) {
        glUniform1i(glGetUniformLocation(program->id(), "uFirst"), first);
        glUniform1i(glGetUniformLocation(program->id(), "uSecond"), second);
        return shade(*program).at(0);
    };
    const int much = limit > 0 ? limit : 1'000'000;
    EXPECT_EQ(counted(much, 0)[0], static_cast<float>(much));
    if (limit == 0) return;
    EXPECT_EQ(counted(limit + 1, 0)[0], static_cast<float>(limit));
    EXPECT_EQ(counted(limit / 2, limit)[0], static_cast<float>(limit / 2));
    EXPECT_LT(counted(limit / 2, limit)[1], static_cast<float>(limit)) << "the second loop has the rest";
}

TEST_F(LoopLimitTest, OfLlvmpipeOfMesa22Is65535) {
    const std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    const bool isKnown = driver().family.find("llvmpipe") != std::string::npos &&
                         version.find("Mesa 22.") != std::string::npos;
    if (!isKnown) GTEST_SKIP() << version << ": the test above compares what is measured with another loop";
    EXPECT_EQ(measureLoopLimit(context()), 65'535);
}

}  // namespace
}  // namespace glibra::gpu
