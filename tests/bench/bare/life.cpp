// glib/modern/life.glib on a board of 1024 x 1024 cells, after 600 generations.

#include <utility>

#include "bare.h"

namespace bare {

void life(const Arguments& arguments) {
    constexpr int kSide = 768;
    const int side = arguments.size > 0 ? arguments.size : 1024;
    const int generations = arguments.steps > 0 ? arguments.steps : 600;
    const GLuint seed = link(arguments.shaders, {"life_seed.comp"});
    const GLuint generation = link(arguments.shaders, {"life.comp"});
    const GLuint show = link(arguments.shaders, {arguments.fill.c_str(), "life.frag"});
    GLuint now = texture2D(GL_R8UI, side, side, GL_NEAREST);
    GLuint before = texture2D(GL_R8UI, side, side, GL_NEAREST);
    const auto groups = static_cast<GLuint>((side + 7) / 8);

    set(seed, "uDensity", .3F);
    set(seed, "uSeed", 7);
    glUseProgram(seed);
    glBindImageTexture(0, now, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    glDispatchCompute(groups, groups, 1);

    set(generation, "uIn", 0);
    set(generation, "uOut", 1);
    glUseProgram(generation);
    for (int i = 0; i < generations; ++i) {
        std::swap(now, before);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glBindImageTexture(0, before, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8UI);
        glBindImageTexture(1, now, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
        glDispatchCompute(groups, groups, 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    const Window window(kSide, kSide);
    window.begin({.05F, .06F, .09F});
    glUseProgram(show);
    set(show, "uAlive", glm::dvec3(.55, .85, .45));
    set(show, "uDead", glm::dvec3(.07, .09, .13));
    glBindTexture(GL_TEXTURE_2D, now);
    fill();
    window.write(arguments.file);
}

}  // namespace bare
