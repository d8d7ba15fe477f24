// The book's terrain grid, 1024 x 569 points, as one triangle strip: each row of cells begins with
// RestartPrimitive.
#include <glibra/classic/classic.h>

#include <cmath>

#include "window.h"

using namespace glibra::classic;

int main(int argc, char** argv) {
    Window window("Grid", argc, argv);
    if (!window) return std::fputs("no window with OpenGL 4.1\n", stderr), 4;

    GLSLProgram program;
    if (!program.Create("cube.vert", "lit.frag")) return 3;

    const int columns = 1024, rows = 569;
    VertexArray grid;
    grid.CollapseCommonVertices(true);
    grid.SetVerbose(true);
    grid.glBegin(GL_TRIANGLE_STRIP);
    for (int row = 0; row + 1 < rows; ++row) {
        grid.RestartPrimitive();
        for (int column = 0; column < columns; ++column)
            for (int up = 1; up >= 0; --up) {
                float x = 2.f * column / (columns - 1) - 1, z = 2.f * (row + up) / (rows - 1) - 1;
                float slopeX = .6f * std::cos(9 * x) * std::cos(6 * z);
                float slopeZ = -.4f * std::sin(9 * x) * std::sin(6 * z);
                float height = .6f / 9 * std::sin(9 * x) * std::cos(6 * z);
                grid.glNormal3f(-slopeX, 1, -slopeZ);
                grid.glColor3f(.4f + 4 * height, .7f, .3f);
                grid.glVertex3f(x, height, z);
            }
    }
    grid.glEnd();

    while (window.next()) {
        Matrix4 model, view, projection;
        model.Rotatef(10 * window.seconds(), 0, 1, 0);
        view.LookAt(0, 1, 2, 0, 0, 0, 0, 1, 0);
        projection.Perspective(50, window.aspect(), .1f, 10);
        program.SetUniform("uModelViewMatrix", view * model);
        program.SetUniform("uProjectionMatrix", projection);
        program.Use();
        grid.Draw();
    }
}
