// All levels are LEVEL: a number, or the uniform.
layout(vertices = 1) out;
flat in int vNumber[];
out int cNumber[];
uniform float uLevel;
void main() {
    cNumber[gl_InvocationID] = vNumber[0];
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = LEVEL;
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = LEVEL;
}
