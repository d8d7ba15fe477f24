// glib/modern/deferred.glib with 64 lamps: 36 draws into three textures, then one light pass.

#include <cstdint>

#include "bare.h"

namespace bare {
namespace {

std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// rand(i, seed) of the language.
double random(std::uint64_t i, std::uint64_t seed) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;
    return static_cast<double>(mix(mix(seed + kGolden) + i * kGolden) >> 11U) * 0x1p-53;
}

}  // namespace

void deferred(const Arguments& arguments) {
    constexpr int kWidth = 900, kHeight = 600;
    const int lampCount = arguments.size > 0 ? arguments.size : 64;
    const GLuint lamps = link(arguments.shaders, {"deferred_lamps.comp"});
    const GLuint surfaces = link(arguments.shaders, {"deferred.vert", "deferred.frag"});
    const GLuint light = link(arguments.shaders, {arguments.fill.c_str(), "deferred_light.frag"});

    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr{32} * lampCount, nullptr, GL_DYNAMIC_COPY);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    glUseProgram(lamps);
    glDispatchCompute(static_cast<GLuint>((lampCount + 63) / 64), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    const GLuint textures[3] = {texture2D(GL_RGBA32F, kWidth, kHeight, GL_NEAREST),
                                texture2D(GL_RGBA16F, kWidth, kHeight, GL_NEAREST),
                                texture2D(GL_RGBA8, kWidth, kHeight, GL_NEAREST)};
    framebuffer({textures[0], textures[1], textures[2]}, 0, kWidth, kHeight);
    glViewport(0, 0, kWidth, kHeight);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::dvec3 eye(0, 5, 9);
    glUseProgram(surfaces);
    set(surfaces, "v_matrix", lookAt(eye, {0, .3, 0}));
    set(surfaces, "p_matrix", perspective(45, static_cast<double>(kWidth) / kHeight, .1, 100));
    const GLint model = locationOf(surfaces, "m_matrix");
    const auto draw = [&](const Mesh& mesh, const glm::dmat4& place, const glm::dvec4& color) {
        set(surfaces, "uColor", color);
        set(surfaces, model, place);
        mesh.draw();
    };
    draw(upload(plane(8), surfaces), glm::dmat4(1), {.7, .7, .72, 1});
    const Mesh ball = upload(sphere(.5, 40, 20), surfaces), spire = upload(pyramid(.9, 1.2), surfaces),
               block = upload(box(.7), surfaces);
    for (unsigned k = 0; k < 35; ++k) {
        const double row = k / 7, column = k % 7;
        const glm::dmat4 place = translation({1.6 * (column - 3), 0, 1.6 * (row - 2)});
        const glm::dvec4 color(.5 + .5 * random(k, 1), .5 + .5 * random(k, 2), .5 + .5 * random(k, 3), 1);
        const glm::dmat4 turned = place * rotation(90 * random(k, 4), {0, 1, 0});
        if (k % 3 == 0)
            draw(ball, place * translation({0, .5, 0}), color);
        else if (k % 3 == 1)
            draw(spire, turned, color);
        else
            draw(block, turned * translation({0, .35, 0}), color);
    }

    const Window window(kWidth, kHeight);
    window.begin({0, 0, 0});
    glUseProgram(light);
    set(light, "uEye", eye);
    set(light, "uReach", 1.6F);
    const char* names[3] = {"places", "normals", "colors"};
    for (int unit = 0; unit < 3; ++unit) {
        set(light, names[unit], unit);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, textures[unit]);
    }
    fill();
    window.write(arguments.file);
}

}  // namespace bare
