// S23 Each side is cut into another number of parts.
#version 410 core
layout(vertices = 4) out;

uniform float uOuter[4];
uniform float uInner[2];

void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    if (gl_InvocationID == 0) {
        for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uOuter[i];
        for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = uInner[i];
    }
}
