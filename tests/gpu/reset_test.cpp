#include "gpu/context/driver_reports.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/device_lost.h"
#include "fixture.h"
#include "gpu/context/errors.h"
#include "gpu/object/buffer.h"
#include "gpu/object/timer.h"

namespace glibra::gpu::test {
namespace {

namespace fs = std::filesystem;

GLenum toldStatus = GL_NO_ERROR;
GLenum tellStatus() {
    return toldStatus;
}

/// A context whose driver reports what the test wants.
class ResetTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        toldStatus = GL_NO_ERROR;
        own_ = glad_glGetGraphicsResetStatus;
        glad_glGetGraphicsResetStatus = tellStatus;
        watchDevice(context().debugLog().places());
    }
    void TearDown() override {
        glad_glGetGraphicsResetStatus = own_;
        watchDevice(context().debugLog().places());
        GpuTest::TearDown();
    }
    /// The cause that is thrown, or nothing.
    template <class Work>
    static std::optional<base::ResetCause> causeOf(const Work& work) {
        try {
            work();
        } catch (const base::DeviceLost& lost) {
            return lost.cause;
        }
        return std::nullopt;
    }

  private:
    PFNGLGETGRAPHICSRESETSTATUSPROC own_ = nullptr;
};

TEST_F(ResetTest, EveryWayInWhichContentComesBackRefusesThatOfALostDevice) {
    const Result<Target> target = Target::window(driver(), 4, 4, TexelFormat::rgba8);
    Result<Buffer> buffer = Buffer::create(std::size_t{16});
    ASSERT_TRUE(target && buffer);
    const Query query(GL_SAMPLES_PASSED);
    query.begin();
    query.end();
    std::array<std::byte, 16> bytes{};
    const std::vector<std::pair<const char*, std::function<void()>>> ways{
        {"pixels",
         [&] { (void)readPixels(driver(), target->readable(), 0, {0, 0, 4, 4}, {4, TexelType::u8}); }},
        {"buffer", [&] { buffer->read(0, bytes); }},
        {"count", [&] { (void)query.result(); }},
        {"availability", [&] { (void)query.isReady(); }},
        {"map",
         [&] {
             buffer->bind(GL_COPY_READ_BUFFER);
             glMapBufferRange(GL_COPY_READ_BUFFER, 0, 16, GL_MAP_READ_BIT);
         }},
        {"finish", [] { glFinish(); }},
        {"messages", [&] { (void)context().debugLog().takeDiagnostics(); }},
    };
    for (const auto& [name, way] : ways) EXPECT_FALSE(causeOf(way)) << name;
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    clearErrors();
    for (const auto& [status, cause] : {std::pair(GL_GUILTY_CONTEXT_RESET, base::ResetCause::own),
                                        std::pair(GL_INNOCENT_CONTEXT_RESET, base::ResetCause::other),
                                        std::pair(GL_UNKNOWN_CONTEXT_RESET, base::ResetCause::unknown)}) {
        watchDevice(context().debugLog().places());
        toldStatus = static_cast<GLenum>(status);
        for (const auto& [name, way] : ways) EXPECT_EQ(causeOf(way), cause) << name;
        toldStatus = GL_NO_ERROR;
        watchDevice(context().debugLog().places());
        glUnmapBuffer(GL_COPY_READ_BUFFER);
        clearErrors();
    }
}

TEST_F(ResetTest, ALossThatIsToldOnceIsNotForgotten) {
    toldStatus = GL_INNOCENT_CONTEXT_RESET;
    EXPECT_TRUE(causeOf(expectDevice));
    toldStatus = GL_NO_ERROR;
    EXPECT_EQ(causeOf(expectDevice), base::ResetCause::other);
    watchDevice(context().debugLog().places());
    EXPECT_FALSE(causeOf(expectDevice));
}

TEST_F(ResetTest, ThePlacesAreThoseSinceTheDeviceWasIdle) {
    DebugLog& log = context().debugLog();
    const auto lost = [&] {
        watchDevice(log.places());
        toldStatus = GL_GUILTY_CONTEXT_RESET;
        base::DeviceLost found;
        try {
            expectDevice();
        } catch (const base::DeviceLost& each) {
            found = each;
        }
        toldStatus = GL_NO_ERROR;
        watchDevice(log.places());
        return found;
    };
    log.setPlace({"a.glib", 3, 1});
    glFinish();
    EXPECT_EQ(lost().place.file, "") << "nothing was being drawn";
    for (const int line : {5, 9, 7}) log.setPlace({"a.glib", line, 1});
    EXPECT_EQ(lost().place, (Place{"a.glib", 5, 1}));
    EXPECT_EQ(lost().lastLine, 9);
    log.setPlace({"b.glib", 2, 4});
    EXPECT_EQ(lost().place, (Place{"b.glib", 2, 4}));
    glFinish();
    log.setPlace({"b.glib", 8, 1});
    EXPECT_EQ(lost().place.line, 8);
    glFinish();
}

TEST_F(ResetTest, ContextsAskToBeLostWithAReset) {
    if (context().driver() == Driver::osmesa) GTEST_SKIP() << "OSMesa cannot";
    GLint strategy = 0;
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    EXPECT_EQ(strategy, GL_LOSE_CONTEXT_ON_RESET);
}

TEST_F(ResetTest, AQueueKeepsTheDeviceNear) {
    WorkQueue queue;
    for (int i = 0; i < 20; ++i) queue.endStep();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// A call of GL that returns what the device has done, and that driver_reports.cpp does not watch, would be
/// believed.
TEST(ResetGuard, CoversEveryFunctionOfTheProgramThatReadsFromTheDevice) {
    const auto textOf = [](const fs::path& file) {
        std::ifstream in(file);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    const fs::path source = fs::path(GLIBRA_SOURCE_DIR) / "src";
    const std::string guards = textOf(source / "gpu/context/driver_reports.cpp");
    // These ask the driver for what it knows without the device: limits, names, the results of compiling.
    // What fails there because the device is lost leaves a log, which is watched.
    const std::set<std::string> harmless{"glGetIntegerv",
                                         "glGetIntegeri_v",
                                         "glGetInteger64v",
                                         "glGetFloatv",
                                         "glGetString",
                                         "glGetStringi",
                                         "glGetInternalformativ",
                                         "glGetQueryiv",
                                         "glGetShaderiv",
                                         "glGetProgramiv",
                                         "glGetUniformLocation",
                                         "glGetAttribLocation",
                                         "glGetFragDataLocation",
                                         "glGetActiveUniform",
                                         "glGetActiveUniformsiv",
                                         "glGetActiveUniformBlockiv",
                                         "glGetActiveUniformBlockName",
                                         "glGetUniformBlockIndex",
                                         "glGetUniformIndices",
                                         "glGetActiveAttrib",
                                         "glGetProgramInterfaceiv",
                                         "glGetProgramResourceiv",
                                         "glGetProgramResourceName",
                                         "glGetProgramResourceIndex",
                                         "glGetRenderbufferParameteriv",
                                         "glGetFramebufferAttachmentParameteriv",
                                         "glGetBooleanv",
                                         "glGetBooleani_v",
                                         "glGetTexLevelParameteriv",
                                         "glReadBuffer",
                                         "glGetGraphicsResetStatus",
                                         "glGetGraphicsResetStatusARB"};
    const std::regex call(R"(\b(gl(Get|Read|Map|Unmap|Finish|ClientWait|Check)\w*)\s*[(),])");
    int found = 0;
    for (const auto& each : fs::recursive_directory_iterator(source)) {
        if (each.path().extension() != ".cpp" && each.path().extension() != ".h") continue;
        const std::string text = textOf(each.path());
        for (std::sregex_iterator at(text.begin(), text.end(), call), end; at != end; ++at) {
            const std::string name = (*at)[1];
            if (harmless.contains(name) || name.find("glad") != std::string::npos) continue;
            ++found;
            EXPECT_NE(guards.find("glad_" + name), std::string::npos) << name << " in " << each.path();
        }
    }
    EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace glibra::gpu::test
