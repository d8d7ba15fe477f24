// 1,000 boxes by one instanced draw, and two shapes of which a buffer of commands says how often each is
// drawn.
#include <glibra/classic/classic.h>

#include "window.h"

using namespace glibra::classic;

namespace {

void box(VertexArray& shape, float size) {
    const int faces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                             {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    shape.glBegin(GL_QUADS);
    for (const auto& face : faces)
        for (int corner : face)
            shape.glVertex3f(size * ((corner & 1) - .5f), size * ((corner >> 1 & 1) - .5f),
                             size * ((corner >> 2 & 1) - .5f));
    shape.glEnd();
}

void pyramid(VertexArray& shape, float size) {
    shape.glBegin(GL_TRIANGLE_FAN);
    shape.glVertex3f(0, size, 0);
    const int around[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (const auto& each : around) shape.glVertex3f(size * each[0] / 2, -size / 2, size * each[1] / 2);
    shape.glEnd();
}

}  // namespace

int main(int argc, char** argv) {
    Window window("Instances", argc, argv);
    if (!window) return std::fputs("no window with OpenGL 4.1\n", stderr), 4;

    GLSLProgram program;
    if (!program.Create("instances.vert", "plain.frag")) return 3;
    VertexArray boxes, shapes;
    box(boxes, .06f);
    box(shapes, .08f);            // list 0
    pyramid(shapes, .1f);         // list 1
    shapes.SetInstances(0, 300);  // a compute shader could write this into CommandBuffer()
    shapes.SetInstances(1, 1000);

    while (window.next()) {
        Matrix4 model, view, projection;
        model.Rotatef(20 * window.seconds(), 0, 1, 0);
        view.LookAt(0, 1, 4, 0, 0, 0, 0, 1, 0);
        projection.Perspective(50, window.aspect(), .1f, 10);
        program.SetUniform("uModelViewMatrix", view * model);
        program.SetUniform("uProjectionMatrix", projection);
        program.Use();
        program.SetUniform("uCentre", -1, 0, 0);
        boxes.DrawInstanced(1000);
        program.SetUniform("uCentre", 1, 0, 0);
        shapes.DrawIndirect();
    }
}
