// glib/modern/cube_cloud.glib: 100,000 cubes from one draw.

#include "bare.h"

namespace bare {

void cubes(const Arguments& arguments) {
    constexpr int kSide = 600;
    const GLuint program = link(arguments.shaders, {"cube_cloud.vert", "rainbow.frag"});
    const Mesh mesh = upload(box(2), program);
    const Window window(kSide, kSide);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    window.begin({0, 0, 0});
    glUseProgram(program);
    set(program, "v_matrix", lookAt({0, 0, 420}, {0, 0, -1000}));
    set(program, "p_matrix", perspective(60, 1, .1, 2000));
    mesh.draw(arguments.size > 0 ? arguments.size : 100'000);
    window.write(arguments.file);
}

}  // namespace bare
