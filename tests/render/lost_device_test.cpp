#include <glad/gl.h>
#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "gpu/context/driver_reports.h"
#include "scene_text.h"

namespace glibra::render {
namespace {

using test::has;

GLenum toldStatus = GL_NO_ERROR;
GLenum tell() {
    return toldStatus;
}

TEST(LostDevice, TheLibraryReportsItAndOpensAnotherContext) {
    const std::filesystem::path scene = std::filesystem::path(GLIBRA_SOURCE_DIR) / "glib/start/teapot.glib";
    Result<Renderer> renderer = Renderer::open();
    ASSERT_TRUE(renderer);
    const Result<Picture> before = renderer->render(scene);
    ASSERT_TRUE(before);
    for (const auto status : std::array<GLenum, 2>{GL_GUILTY_CONTEXT_RESET, GL_INNOCENT_CONTEXT_RESET}) {
        gpu::WorkPlaces places;
        glad_glGetGraphicsResetStatus = tell;
        gpu::watchDevice(places);
        toldStatus = status;
        const Result<Picture> lost = renderer->render(scene);
        EXPECT_FALSE(lost);
        EXPECT_TRUE(has(lost.diagnostics, status == GL_GUILTY_CONTEXT_RESET ? "gpu-E06" : "gpu-E07"))
            << test::text(lost.diagnostics);
        toldStatus = GL_NO_ERROR;
        const Result<Picture> again = renderer->render(scene);
        ASSERT_TRUE(again) << test::text(again.diagnostics);
        EXPECT_TRUE(test::isSame(*before, *again));
    }
}

}  // namespace
}  // namespace glibra::render
