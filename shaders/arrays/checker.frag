// V17 A checkerboard of 8 x 8 fields.
#version 330

in vec2 vST;
out vec4 fColor;

void main() {
    ivec2 field = ivec2(8. * vST);
    fColor = vec4(vec3((field.x + field.y) % 2), 1.);
}
