// uLevels: outer, inner, and the steps by which the inner one grows from patch to patch.
layout(vertices = 1) out;
in float vPatch[];
out float cPatch[];
uniform vec3 uLevels;
void main() {
    cPatch[gl_InvocationID] = vPatch[0];
    float inner = uLevels.y + uLevels.z * mod(vPatch[0], 3.);
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uLevels.x;
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inner;
}
