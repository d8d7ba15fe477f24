// glib/modern/flat_water.glib: what a level water mirrors and what shines through, from two more cameras.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bare.h"

namespace bare {
namespace {

/// The lens with its near plane in that plane of eye space (Lengyel 2005).
glm::dmat4 withNearPlane(glm::dmat4 lens, const glm::dvec4& plane) {
    const glm::dvec4 corner =
        glm::inverse(lens) * glm::dvec4(plane.x < 0 ? -1 : 1, plane.y < 0 ? -1 : 1, 1, 1);
    const glm::dvec4 scaled = plane * (2 / glm::dot(plane, corner));
    for (int column = 0; column < 4; ++column) lens[column][2] = scaled[column] - lens[column][3];
    return lens;
}

struct Camera {
    glm::dmat4 view, lens;
};

}  // namespace

void water(const Arguments& arguments) {
    constexpr int kWidth = 900, kHeight = 700;
    const GLuint sky = link(arguments.shaders, {"sky.vert", "sky.frag"});
    const GLuint floor = link(arguments.shaders, {"water.vert", "flat_floor.frag"});
    const GLuint post = link(arguments.shaders, {"post.vert", "post.frag"});
    const GLuint surface = link(arguments.shaders, {"water.vert", "flat_water.frag"});
    const Mesh skyMesh = upload(skyBox(2), sky), floorMesh = upload(plane(128), floor),
               postMesh = upload(cylinder(.6, 14, 24), post);
    for (const GLuint each : {sky, floor, post, surface}) set(each, "uSun", glm::dvec3(-2, 1.6, -6));
    set(floor, "uTiles", 64.F);
    set(floor, "m_matrix", translation({0, -10, 0}));
    set(surface, "m_matrix", glm::dmat4(1));
    set(surface, "isAbove", 1);

    Camera eye;
    eye.view = lookAt({0, 2, 40}, {0, 2 + std::tan(-15 * 3.14159265358979323846 / 180), 39});
    eye.lens = perspective(55, static_cast<double>(kWidth) / kHeight, .1, 1000);
    Camera mirror = eye;
    glm::dmat4 reflection(1);
    reflection[1][1] = -1;
    mirror.view = eye.view * reflection;
    glm::dvec4 plane = glm::transpose(glm::inverse(mirror.view)) * glm::dvec4(0, 1, 0, 0);
    plane /= glm::length(glm::dvec3(plane));
    mirror.lens = withNearPlane(eye.lens, plane.w > 0 ? -plane : plane);

    const auto look = [](GLuint program, const Camera& camera) {
        set(program, "v_matrix", camera.view);
        set(program, "p_matrix", camera.lens);
        glUseProgram(program);
    };
    const auto drawSky = [&](const Camera& camera) {
        glm::dmat4 view = camera.view;
        view[3] = {0, 0, 0, 1};
        glUseProgram(sky);
        set(sky, "mvp_matrix", camera.lens * view);
        glEnable(GL_DEPTH_CLAMP);
        glDepthRange(1, 1);
        skyMesh.draw();
        glDepthRange(0, 1);
        glDisable(GL_DEPTH_CLAMP);
    };
    const auto drawFloor = [&](const Camera& camera) {
        look(floor, camera);
        set(floor, "cameraPosition", glm::dvec3(glm::inverse(camera.view)[3]));
        floorMesh.draw();
    };
    const auto drawPosts = [&](const Camera& camera, float side) {
        look(post, camera);
        set(post, "uSide", side);
        const GLint model = locationOf(post, "m_matrix");
        glEnable(GL_CLIP_DISTANCE0);
        for (int k = 0; k < 5; ++k) {
            set(post, model, translation({3.5 * k - 6, -10, 24 - 12 * k}));
            postMesh.draw();
        }
        glDisable(GL_CLIP_DISTANCE0);
    };

    const GLuint reflected = texture2D(GL_RGBA8, kWidth, kHeight, GL_LINEAR);
    const GLuint refracted = texture2D(GL_RGBA8, kWidth, kHeight, GL_LINEAR);
    const Window window(kWidth, kHeight);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glViewport(0, 0, kWidth, kHeight);
    glClearColor(.25F, .36F, .55F, 1);
    framebuffer({reflected}, 0, kWidth, kHeight);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawSky(mirror);
    drawFloor(mirror);
    drawPosts(mirror, 0);
    framebuffer({refracted}, 0, kWidth, kHeight);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawFloor(eye);
    drawPosts(eye, -1);

    window.begin({.25F, .36F, .55F});
    drawSky(eye);
    drawPosts(eye, 1);
    look(surface, eye);
    set(surface, "cameraPosition", glm::dvec3(0, 2, 40));
    set(surface, "refraction", 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, refracted);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, reflected);
    floorMesh.draw();
    window.write(arguments.file);
}

}  // namespace bare
