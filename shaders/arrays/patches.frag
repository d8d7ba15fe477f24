// V11 Patchwork: triangle i has colour i mod 4.
#version 330

uniform vec3 uColors[4];

out vec4 fColor;

void main() {
    fColor = vec4(uColors[gl_PrimitiveID % 4], 1.);
}
