// S19 Between the three corners: gl_TessCoord holds the weights of the corners.
#version 400
layout(triangles, equal_spacing, ccw) in;

void main() {
    vec4 place = vec4(0.);
    for (int i = 0; i < 3; ++i) place += gl_TessCoord[i] * gl_in[i].gl_Position;
    gl_Position = uModelViewProjectionMatrix * place;
}
