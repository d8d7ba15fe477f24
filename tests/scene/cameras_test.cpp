// Warnings about cameras (language, 12.3).

#include <gtest/gtest.h>

#include <string>

#include "support.h"

namespace glibra::scene {
namespace {

using tests::run;
using tests::textsOf;

const std::string kEye = "Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n";

TEST(Cameras, AnEyeAfterEverythingThatIsDrawnIsReported) {
    const std::string late =
        "2:1 glib-W41 Camera 'eye' stands after everything that is drawn, so nothing is seen by it; move it "
        "up";
    EXPECT_EQ(textsOf(run("Sphere 1\n" + kEye).diagnostics), late);
    EXPECT_EQ(textsOf(run("Repeat 2\nSphere 1\nEndRepeat\n" + kEye).diagnostics).substr(4), late.substr(4));
    for (const char* before : {"", "Sphere 1\n"})
        for (const char* after :
             {"Sphere 1\n", "Pass window\nSphere 1\nEndPass\n",
              "Camera right Shift eye .1 0 0\nPass window from right\nSphere 1\nEndPass\n",
              "Let x (eye.position.x)\n", "Pass window from eye\nEndPass\n"})
            EXPECT_EQ(textsOf(run(before + kEye + after).diagnostics), "") << before << after;
}

}  // namespace
}  // namespace glibra::scene
