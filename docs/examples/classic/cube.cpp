// The book's cube: six quads whose 24 vertices are collapsed to 8, and a lit one beside it with the 24 that
// have normals.
#include <glibra/classic/classic.h>

#include "window.h"

using namespace glibra::classic;

namespace {

const int kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
const float kNormals[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

VertexArray makeCube(bool hasNormals) {
    VertexArray cube;
    cube.CollapseCommonVertices(true);
    cube.SetTol(.001f);
    cube.SetVerbose(true);
    cube.glBegin(GL_QUADS);
    for (int face = 0; face < 6; ++face)
        for (int corner : kFaces[face]) {
            float x = corner & 1, y = corner >> 1 & 1, z = corner >> 2 & 1;
            if (hasNormals) cube.glNormal3fv(kNormals[face]);
            cube.glColor3f(x, y, z);
            cube.glVertex3f(2 * x - 1, 2 * y - 1, 2 * z - 1);
        }
    cube.glEnd();
    return cube;
}

}  // namespace

int main(int argc, char** argv) {
    Window window("Cube", argc, argv);
    if (!window) return std::fputs("no window with OpenGL 4.1\n", stderr), 4;

    GLSLProgram plain, lit;
    if (!plain.Create("cube.vert", "plain.frag") || !lit.Create("cube.vert", "lit.frag")) return 3;
    VertexArray colors = makeCube(false), normals = makeCube(true);

    while (window.next()) {
        Matrix4 view, projection;
        view.LookAt(0, 2, 7, 0, 0, 0, 0, 1, 0);
        projection.Perspective(50, window.aspect(), .1f, 100);
        for (int i = 0; i < 2; ++i) {
            Matrix4 model;
            model.Rotatef(40 * window.seconds(), 0, 1, 0).Translatef(i == 0 ? -1.8f : 1.8f, 0, 0);
            GLSLProgram& program = i == 0 ? plain : lit;
            program.SetUniform("uProjectionMatrix", projection);
            program.SetUniform("uModelViewMatrix", view * model);
            program.Use();
            (i == 0 ? colors : normals).Draw();
        }
    }
}
