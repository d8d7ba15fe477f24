// S14 Each primitive twice: as it is, and with x and y exchanged.
#version 120
#extension GL_EXT_geometry_shader4 : enable

void main() {
    for (int i = 0; i < gl_VerticesIn; ++i) {
        gl_FrontColor = gl_FrontColorIn[i];
        gl_Position = gl_PositionIn[i];
        EmitVertex();
    }
    EndPrimitive();
    for (int i = 0; i < gl_VerticesIn; ++i) {
        gl_FrontColor = gl_FrontColorIn[i].bgra;
        gl_Position = gl_PositionIn[i].yxzw;
        EmitVertex();
    }
    EndPrimitive();
}
