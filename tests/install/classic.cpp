// A program with a loader of its own, whose header has macros of the names of old OpenGL: the classes work,
// and neither loader takes the place of the other.
#define glBegin host_glBegin
#define glVertex2f host_glVertex2f
#define glEnd host_glEnd
#include <glibra/classic/classic.h>

extern "C" {
void* glad_glClear = nullptr;
void* glad_glDrawArrays = nullptr;
int gladLoadGLUserPtr(void*, void*) {
    return 0;
}
}

int main() {
    using namespace glibra::classic;
    VertexArray array;
    array.CollapseCommonVertices(true);
    array.glBegin(GL_LINES);
    for (int i = 0; i < 4; ++i) array.glVertex2f(static_cast<float>(i / 2), 0);
    array.glEnd();
    const Point3 moved = Matrix4().Translatef(1, 2, 3) * Point3(1, 1, 1);
    GLSLProgram program;
    return array.NumUnique() == 2 && moved.z == 4 && !program.IsValid() ? 0 : 1;
}
