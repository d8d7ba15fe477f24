// Compares listed calls with calls made by hand.

#include "gpu/context/call_counter.h"

#include <array>

#include "fixture.h"

namespace glibra::gpu {
namespace {

class CallTraceTest : public test::GpuTest {};

TEST_F(CallTraceTest, ListsCallsWithArgumentsUnderTheirPlaces) {
    WorkPlaces places;
    const CallCounter counter;
    const CallTrace trace(places);
    glEnable(GL_DEPTH_TEST);
    places.set({"scene.glib", 3, 1});
    glActiveTexture(GL_TEXTURE0 + 2);
    glViewport(0, 1, 20, 30);
    glViewport(0, 1, 20, 30);
    glPolygonOffset(.5F, -2);
    places.set({"scene.glib", 7, 1});
    const std::array<float, 4> color{};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color.data());
    glDepthMask(GL_FALSE);
    EXPECT_EQ(trace.text(),
              "before the first statement\n  glEnable(GL_DEPTH_TEST)\n"
              "scene.glib:3\n  glActiveTexture(GL_TEXTURE2)\n  glViewport(0, 1, 20, 30) x 2\n"
              "  glPolygonOffset(0.5, -2)\n"
              "scene.glib:7\n  glTexParameterfv(...)\n"
              "  glDepthMask(GL_FALSE)\n");
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

TEST_F(CallTraceTest, ListsNothingAfterItsEnd) {
    const WorkPlaces places;
    const CallCounter counter;
    {
        const CallTrace ended(places);
    }
    glGetError();
    const CallTrace trace(places);
    EXPECT_EQ(trace.text(), "");
}

}  // namespace
}  // namespace glibra::gpu
