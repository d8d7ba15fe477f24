// draw-W19: projections and places beyond the precision of floats.

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

TEST(Precision, OfADepthBufferBetweenPlanesFarApartIsReported) {
    const auto found = [](const std::string& planes) {
        return problemsOf("WindowSize 16 16\nPerspective 50 " + planes +
                          "\nLookAt 0 0 10  0 0 0  0 1 0\nSphere 1\nSphere 2\n");
    };
    const std::string far = found("1e-6 1e6");
    EXPECT_NE(far.find("scene.glib:4:1: warning: near 1e-06 and far 1000000"), std::string::npos) << far;
    EXPECT_EQ(far.find("draw-W19"), far.rfind("draw-W19")) << "once: " << far;
    EXPECT_EQ(found(".1 1000").find("draw-W19"), std::string::npos);
    EXPECT_EQ(found(".01 10000").find("draw-W19"), std::string::npos);
}

/// A ball at `place`, seen from ten units in front of it by a program with these matrices.
std::string seenAt(const std::string& place, const std::string& matrices, const std::string& product,
                   const std::string& tags = {}) {
    return "WindowSize 16 16\nCamera eye LookAt " + place + " 0 10  " + place +
           " 0 0  0 1 0  Perspective 50 .1 100\nVertex inline\n#version 330\nuniform mat4 " + matrices +
           ";\nin vec3 vertPos;\nvoid main() { gl_Position = " + product +
           " * vec4(vertPos, 1.); }\nEndVertex\nFragment inline\n#version 330\nout vec4 c;\nvoid main() { c "
           "= "
           "vec4(1.); }\nEndFragment\nProgram P " +
           tags + "\nTranslate " + place + " 0 0\nSphere 1\n";
}

TEST(Precision, OfMatricesThatAShaderMultipliesIsReportedFarFromTheOrigin) {
    const auto reports = [](const std::string& scene) {
        return problemsOf(scene).find("draw-W19") != std::string::npos;
    };
    const std::string apart = "m_matrix, v_matrix, proj_matrix",
                      product = "proj_matrix * v_matrix * m_matrix";
    EXPECT_TRUE(reports(seenAt("1e7", apart, product)));
    EXPECT_TRUE(reports(seenAt("1e6", apart, product)));
    EXPECT_FALSE(reports(seenAt("1000", apart, product)));
    EXPECT_FALSE(reports(seenAt("1e7", "mv_matrix, proj_matrix", "proj_matrix * mv_matrix")));
    EXPECT_FALSE(reports(seenAt("1e7", "mvp", "mvp")));
    const std::string tags = "uM (model) uV (eye.view) uP (eye.projection)";
    EXPECT_TRUE(reports(seenAt("1e7", "uM, uV, uP", "uP * uV * uM", tags)));
    EXPECT_FALSE(reports(seenAt("10", "uM, uV, uP", "uP * uV * uM", tags)));
}

}  // namespace
}  // namespace glibra::test
