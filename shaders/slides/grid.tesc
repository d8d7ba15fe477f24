// S17 The same levels as a control stage states them.
#version 400
layout(vertices = 4) out;

uniform float uOuter, uInner;

void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    if (gl_InvocationID == 0) {
        for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uOuter;
        for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = uInner;
    }
}
