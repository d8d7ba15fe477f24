#include "gpu/context/capabilities.h"

#include <algorithm>

#include "fixture.h"
#include "gpu/context/context.h"

namespace glibra::gpu {
namespace {

class CapabilitiesTest : public test::GpuTest {};

TEST_F(CapabilitiesTest, MeetTheMinimaOfOpenGl41) {
    // OpenGL 4.1 core specification, tables 6.50 to 6.62.
    const Capabilities& limits = driver();
    EXPECT_GE(limits.glslVersion, 410);
    EXPECT_GE(limits.max2DTextureSide, 16384);
    EXPECT_GE(limits.max3DTextureSide, 2048);
    EXPECT_GE(limits.maxCubeSide, 16384);
    EXPECT_GE(limits.maxRenderbufferSide, 16384);
    EXPECT_GE(limits.maxSamples, 4);
    EXPECT_GE(limits.maxDrawBuffers, 8);
    EXPECT_GE(limits.fragmentTextureUnits, 16);
    EXPECT_GE(limits.combinedTextureUnits, 80);
    EXPECT_GE(limits.maxVertexAttributes, 16);
    EXPECT_GE(limits.maxGeometryOutputVertices, 256);
    EXPECT_GE(limits.maxGeometryTotalOutputComponents, 1024);
    EXPECT_GE(limits.maxTessellationLevel, 64);
    EXPECT_GE(limits.maxPatchVertices, 32);
    EXPECT_GE(limits.maxClipDistances, 8);
    EXPECT_GE(limits.maxVertexUniformComponents, 1024);
    EXPECT_GE(limits.maxUniformBlockBytes, 16384);
    EXPECT_GE(limits.maxPointSize, 1);
}

TEST_F(CapabilitiesTest, ExtensionsAreFoundByTheirWholeName) {
    ASSERT_FALSE(driver().extensions.empty());
    for (const std::string& each : driver().extensions) EXPECT_TRUE(driver().hasExtension(each)) << each;
    EXPECT_FALSE(driver().hasExtension("GL_ARB"));
    EXPECT_FALSE(driver().hasExtension("GL_NOBODY_has_this"));
}

TEST_F(CapabilitiesTest, TheNewestGlslVersionCompiles) {
    const std::string version = "#version " + std::to_string(driver().glslVersion) + " core\n";
    const std::string fragment = version + "out vec4 fColor; void main() { fColor = vec4(.25, .5, .75, 1); }";
    const std::string vertex =
        version +
        "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0, 1); }";
    const auto program = build(vertex, fragment);
    ASSERT_TRUE(program);
    EXPECT_EQ(shade(*program).at(0), (test::Rgba{.25F, .5F, .75F, 1}));
}

TEST_F(CapabilitiesTest, InfoHasEveryKeyOnceAndALineForEach) {
    const std::vector<InfoEntry> entries = describe(context());
    std::vector<std::string> keys;
    keys.reserve(entries.size());
    for (const InfoEntry& each : entries) keys.push_back(each.key);
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
    const std::string lines = toText(entries);
    EXPECT_EQ(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')), entries.size());
    EXPECT_NE(lines.find(driver().renderer), std::string::npos);
    EXPECT_NE(lines.find(context().howOpened()), std::string::npos);
}

}  // namespace
}  // namespace glibra::gpu
