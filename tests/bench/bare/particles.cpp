// glib/modern/fountain.glib with a million particles, after 300 steps.

#include "bare.h"

namespace bare {

void particles(const Arguments& arguments) {
    constexpr int kWidth = 800, kHeight = 600;
    const int count = arguments.size > 0 ? arguments.size : 1'000'000;
    const int steps = arguments.steps > 0 ? arguments.steps : 300;
    const GLuint launch = link(arguments.shaders, {"fountain_launch.comp"});
    const GLuint move = link(arguments.shaders, {"fountain_move.comp"});
    const GLuint drops = link(arguments.shaders, {"fountain.vert", "fountain.frag"});
    constexpr GLsizeiptr kParticle = 32;  // two vec3 of std430
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, kParticle * count, nullptr, GL_DYNAMIC_COPY);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    const auto groups = static_cast<GLuint>((count + 63) / 64);

    for (const GLuint each : {launch, move}) {
        set(each, "uSpeed", 7.2F);
        set(each, "uGravity", 9.81F);
        set(each, "uSpread", .22F);
    }
    set(move, "uStep", static_cast<float>(1. / 60));
    glUseProgram(launch);
    glDispatchCompute(groups, 1, 1);
    glUseProgram(move);
    for (int i = 0; i < steps; ++i) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        glDispatchCompute(groups, 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    const Window window(kWidth, kHeight);
    window.begin({.02F, .03F, .06F});
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glPointSize(2);
    glUseProgram(drops);
    set(drops, "mvp_matrix",
        perspective(45, static_cast<double>(kWidth) / kHeight, .1, 100) * lookAt({0, 2.2, 7}, {0, 1.4, 0}));
    set(drops, "uSpeed", 7.2F);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glDrawArrays(GL_POINTS, 0, count);
    window.write(arguments.file);
}

}  // namespace bare
