// S22 Each patch shrinks toward its centre and is as bright as its longest side is long: both come from the shared value.
#version 400
layout(triangles, equal_spacing, ccw) in;

uniform float uShrink;

patch in vec4 tCentre;
out vec3 vModel;
out vec3 vInPatch;
out float vLongest;

void main() {
    vec3 place = vec3(0.);
    for (int i = 0; i < 3; ++i) place += gl_TessCoord[i] * gl_in[i].gl_Position.xyz;
    vModel = tCentre.xyz;
    vLongest = tCentre.w;
    vInPatch = gl_TessCoord;
    gl_Position = uModelViewProjectionMatrix * vec4(mix(place, tCentre.xyz, uShrink), 1.);
}
