#include "gpu/context/context.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <thread>

#include "fixture.h"
#include "gpu/object/buffer.h"
#include "system/library.h"
#include "system/places.h"
#include "unset_variable.h"

namespace glibra::gpu {
namespace {

using test::text;

std::size_t entries(const char* folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

/// A coloured triangle with sloping edges over a background, as bytes.
std::vector<std::byte> trianglePicture(const Context& context) {
    static constexpr const char* kVertex = R"(#version 410 core
out vec3 vColor;
void main() {
    vec2 corner = gl_VertexID == 0 ? vec2(-.9, -.7) : gl_VertexID == 1 ? vec2(.8, -.3) : vec2(-.1, .95);
    vColor = vec3(gl_VertexID == 0, gl_VertexID == 1, gl_VertexID == 2);
    gl_Position = vec4(corner, 0, 1);
}
)";
    static constexpr const char* kFragment = R"(#version 410 core
in vec3 vColor;
out vec4 fColor;
void main() { fColor = vec4(vColor * (.7 + .3 * sin(20. * vColor.x)), 1); }
)";
    const std::array<StageSource, 2> stages{{{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}}};
    const BuildOutcome built = buildProgram(context.capabilities(), {.stages = stages});
    const auto target = Target::window(context.capabilities(), 97, 61, TexelFormat::rgba8);
    if (!built.program || !target) return {};
    const VertexArray nothing({});
    target->bind();
    target->clearColor(0, {.1F, .2F, .3F, 1});
    target->clearDepth();
    nothing.bind();
    built.program->use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    auto picture = readPixels(context.capabilities(), target->readable(), 0, {0, 0, 97, 61}, {});
    return picture ? std::move(*picture) : std::vector<std::byte>{};
}

TEST(OpenContext, AutomaticFindsACoreContextOfFourPointOneOrLater) {
    const auto context = openContext();
    ASSERT_TRUE(context) << text(context.diagnostics);
    const Capabilities& driver = context->capabilities();
    EXPECT_TRUE(driver.atLeast(4, 1));
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_FALSE(context->howOpened().empty());
    EXPECT_TRUE(context->debugLog().take().empty());
}

TEST(OpenContext, EveryDriverOfTheMachineDrawsTheSamePixelsWhenTheRendererIsTheSame) {
    std::map<std::string, std::vector<std::byte>> pictureOf;
    int opened = 0;
    for (const Driver driver : {Driver::egl, Driver::eglDevice, Driver::osmesa}) {
        const auto context = openContext({.driver = driver});
        if (!context) continue;
        ++opened;
        EXPECT_EQ(context->driver(), driver);
        const std::vector<std::byte> picture = trianglePicture(*context);
        ASSERT_EQ(picture.size(), 97U * 61U * 4U);
        const auto [known, isNew] = pictureOf.emplace(context->capabilities().renderer, picture);
        EXPECT_EQ(known->second, picture) << word(driver) << " through " << context->howOpened();
        EXPECT_TRUE(context->debugLog().takeDiagnostics().empty());
    }
    EXPECT_GT(opened, 0);
}

TEST(OpenContext, LinesMayBeWide) {
    const auto context = openContext();
    ASSERT_TRUE(context);
    if (context->capabilities().maxLineWidth <= 1) GTEST_SKIP() << "this driver has no wide lines at all";
    ASSERT_TRUE(context->capabilities().wideLines);
    glLineWidth(static_cast<float>(context->capabilities().maxLineWidth));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(OpenContext, CubeMapsAreSeamlessAndNothingIsDithered) {
    const auto context = openContext();
    ASSERT_TRUE(context);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS));
    EXPECT_FALSE(glIsEnabled(GL_DITHER));
}

TEST(OpenContext, LlvmpipeIsToldToFilterInFloatUnlessTheUserSaysOtherwise) {
    // The driver reads the variable once, at the first context of the process, whichever test opens it.
    (void)openContext();
    system::removeVariable("GALLIVM_PERF");
    (void)openContext({.floatFiltering = false});
    EXPECT_EQ(std::getenv("GALLIVM_PERF"), nullptr);
    (void)openContext();
    EXPECT_STREQ(std::getenv("GALLIVM_PERF"), "no_aos_sampling");
    system::setVariable("GALLIVM_PERF", "no_quad_lod", system::Replace::yes);
    (void)openContext();
    EXPECT_STREQ(std::getenv("GALLIVM_PERF"), "no_quad_lod");
    system::removeVariable("GALLIVM_PERF");
}

TEST(OpenContext, AMissingEglLibraryIsOneDiagnosticThatSaysWhy) {
    const auto context = openContext({.driver = Driver::egl, .eglLibrary = "libnosuchthing.so.1"});
    ASSERT_FALSE(context);
    ASSERT_EQ(context.diagnostics.size(), 1U);
    EXPECT_EQ(context.diagnostics[0].id, "gpu-E01");
    EXPECT_EQ(context.diagnostics[0].severity, Severity::error);
    EXPECT_NE(context.diagnostics[0].text.find("libnosuchthing.so.1"), std::string::npos);
    EXPECT_EQ(context.diagnostics[0].text.find('\n'), std::string::npos);
}

TEST(OpenContext, WithoutAnyLibraryEveryWayTriedIsNamed) {
    const test::UnsetVariable driver("GALLIUM_DRIVER");  // OSMesa has no other one
    const auto context =
        openContext({.eglLibrary = "libnosuchthing.so.1", .osmesaLibraries = {"libnosuchmesa.so.8"}});
    ASSERT_FALSE(context);
    ASSERT_EQ(context.diagnostics.size(), 1U);
    for (const char* part : {"EGL without a surface", "EGL device", "OSMesa", "libnosuchmesa.so.8",
                             ". Mesa draws without a graphics card"})
        EXPECT_NE(context.diagnostics[0].text.find(part), std::string::npos) << context.diagnostics[0].text;
}

TEST(OpenContext, WithoutOsmesaTheMessageSaysWhatDrawsInstead) {
    const test::UnsetVariable driver("GALLIUM_DRIVER");
    const auto context = openContext({.driver = Driver::osmesa, .osmesaLibraries = {"libnosuchmesa.so.8"}});
    ASSERT_FALSE(context);
    EXPECT_NE(context.diagnostics[0].text.find("OSMesa: libnosuchmesa.so.8: "), std::string::npos);
    EXPECT_NE(context.diagnostics[0].text.find("from version 25.1 on; --driver egl draws the same pictures"),
              std::string::npos)
        << context.diagnostics[0].text;
}

TEST(OpenContext, ALibraryThatIsSomethingElseIsRefused) {
    const test::UnsetVariable driver("GALLIUM_DRIVER");
    const auto egl = openContext({.driver = Driver::egl, .eglLibrary = "libm.so.6"});
    ASSERT_FALSE(egl);
    EXPECT_NE(egl.diagnostics[0].text.find("is not an EGL library"), std::string::npos)
        << egl.diagnostics[0].text;
    const auto osmesa = openContext({.driver = Driver::osmesa, .osmesaLibraries = {"libm.so.6"}});
    ASSERT_FALSE(osmesa);
    EXPECT_NE(osmesa.diagnostics[0].text.find("not an OSMesa library"), std::string::npos)
        << osmesa.diagnostics[0].text;
}

TEST(OpenContext, OsmesaIsTakenWhereEglIsMissing) {
    const auto context = openContext({.eglLibrary = "libnosuchthing.so.1"});
    if (!context) GTEST_SKIP() << "no OSMesa here";
    EXPECT_EQ(context->driver(), Driver::osmesa);
    EXPECT_EQ(context->failedWays().size(), 2U);
    EXPECT_TRUE(context->capabilities().family.starts_with("osmesa-")) << context->capabilities().family;
}

TEST(OpenContext, OpeningAgainAndAgainKeepsNoFilesAndNoThreads) {
    (void)openContext();
    const std::size_t files = entries("/proc/self/fd");
    const std::size_t threads = entries("/proc/self/task");
    constexpr std::size_t kTimes = 12;
    for (std::size_t i = 0; i < kTimes; ++i) {
        const auto context = openContext();
        ASSERT_TRUE(context);
        ASSERT_FALSE(trianglePicture(*context).empty());
    }
    // A thread that writes Mesa's cache may have a file open for a moment, here or when the first count was
    // made.
    for (int i = 0; i < 100 && entries("/proc/self/fd") > files; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_LE(entries("/proc/self/fd"), files);
    // Zink begins a few more after the first context, once.
    EXPECT_LT(entries("/proc/self/task"), threads + kTimes / 2);
}

TEST(OpenContext, AMovedContextIsTheSameContext) {
    auto first = openContext();
    ASSERT_TRUE(first);
    const DebugLog* log = &first->debugLog();
    Context second = std::move(*first);
    EXPECT_EQ(&second.debugLog(), log);
    EXPECT_TRUE(second.makeCurrent());
    EXPECT_FALSE(trianglePicture(second).empty());
}

TEST(Adopt, TakesOverACurrentContextAndLeavesItAlive) {
    const auto owner = openContext();
    ASSERT_TRUE(owner);
    if (owner->driver() == Driver::osmesa) GTEST_SKIP() << "no EGL here";
    std::string why;
    const auto library = system::Library::open("libEGL.so.1", system::Library::When::whenCalled, why);
    ASSERT_TRUE(library) << why;
    using GetProcAddress = void* (*)(const char*);
    const auto find = library.find<GetProcAddress>("eglGetProcAddress");
    {
        const auto adopted = adopt(find);
        ASSERT_TRUE(adopted) << text(adopted.diagnostics);
        EXPECT_EQ(adopted->driver(), Driver::automatic);
        EXPECT_EQ(adopted->capabilities().renderer, owner->capabilities().renderer);
        EXPECT_FALSE(trianglePicture(*adopted).empty());
    }
    EXPECT_FALSE(trianglePicture(*owner).empty());
}

TEST(Adopt, ALoaderThatFindsNothingIsAnError) {
    const auto context = adopt([](const char*) -> void* { return nullptr; });
    ASSERT_FALSE(context);
    EXPECT_EQ(context.diagnostics.at(0).id, "gpu-E01");
    EXPECT_FALSE(adopt({}));
}

TEST(DriverWords, NameEachDriverAndNothingElse) {
    for (const Driver driver : {Driver::automatic, Driver::egl, Driver::eglDevice, Driver::osmesa}) {
        const auto found = driverOfWord(word(driver));
        ASSERT_TRUE(found);
        EXPECT_EQ(*found, driver);
    }
    EXPECT_FALSE(driverOfWord("direct3d"));
}

}  // namespace
}  // namespace glibra::gpu
