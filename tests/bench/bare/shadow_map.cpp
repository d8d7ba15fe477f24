// glib/modern/soft_shadow.glib: a shadow map, read 64 times per pixel.

#include <glm/matrix.hpp>

#include "bare.h"

namespace bare {

void shadowMap(const Arguments& arguments) {
    constexpr int kSide = 600, kMap = 1024;
    const GLuint depth = link(arguments.shaders, {"depth.vert"});
    const GLuint lit = link(arguments.shaders, {"shadowed.vert", "shadow_map.frag"});

    const glm::dvec3 eyePosition(0, .2, 6), lightPosition(-3.8, 2.2, 1.1);
    const glm::dmat4 eye = lookAt(eyePosition, {0, .1, 0}), light = lookAt(lightPosition, {0, 0, 0});
    const glm::dmat4 eyeLens = perspective(50, 1, .1, 1000), lightLens = perspective(60, 1, .1, 1000);
    glm::dmat4 half(.5);
    half[3] = {.5, .5, .5, 1};

    struct Object {
        Mesh mesh;
        glm::dmat4 model;
        glm::dvec4 ambient, diffuse, specular;
        float shininess;
    };
    const Object objects[] = {{upload(torus(.6, .4, 48, 96), lit),
                               translation({1.6, 0, -.3}) * rotation(25, {1, 0, 0}) * rotation(90, {1, 0, 0}),
                               {.2125, .1275, .054, 1},
                               {.714, .4284, .1814, 1},
                               {.3935, .2719, .1667, 1},
                               25.6F},
                              {upload(pyramid(2, 2), lit),
                               translation({-1, .1, .3}) * rotation(30, {1, 0, 0}) * rotation(40, {0, 1, 0}) *
                                   translation({0, -1, 0}),
                               {.2473, .1995, .0745, 1},
                               {.7516, .6065, .2265, 1},
                               {.6283, .5558, .3661, 1},
                               51.2F}};

    const GLuint map = texture2D(GL_DEPTH_COMPONENT32F, kMap, kMap, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const GLfloat border[4] = {1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    const Window window(kSide, kSide);

    framebuffer({}, map, kMap, kMap);
    glViewport(0, 0, kMap, kMap);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    glUseProgram(depth);
    set(depth, "v_matrix", light);
    set(depth, "p_matrix", lightLens);
    for (const Object& each : objects) {
        set(depth, "m_matrix", each.model);
        each.mesh.draw();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);

    window.begin({0, 0, 0});
    glUseProgram(lit);
    set(lit, "v_matrix", eye);
    set(lit, "p_matrix", eyeLens);
    set(lit, "cameraPosition", eyePosition);
    set(lit, "light.position", lightPosition);
    set(lit, "light.diffuse", glm::dvec4(1));
    set(lit, "light.specular", glm::dvec4(1));
    set(lit, "light.ambient", glm::dvec4(0, 0, 0, 1));
    set(lit, "globalAmbient", glm::dvec4(.7, .7, .7, 1));
    set(lit, "uGrid", 8);
    set(lit, "uWidth", 2.5F);
    set(lit, "uBias", .01F);
    for (const Object& each : objects) {
        set(lit, "m_matrix", each.model);
        set(lit, "norm_matrix", glm::transpose(glm::inverse(each.model)));
        set(lit, "uShadowMatrix", half * lightLens * light * each.model);
        set(lit, "material.ambient", each.ambient);
        set(lit, "material.diffuse", each.diffuse);
        set(lit, "material.specular", each.specular);
        set(lit, "material.shininess", each.shininess);
        each.mesh.draw();
    }
    window.write(arguments.file);
}

}  // namespace bare
