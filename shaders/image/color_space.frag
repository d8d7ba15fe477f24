// R58 Colour spaces: one matrix per pixel gives the coordinates of a colour in another space, shown as a colour or one of them as grey.
#version 330 core

uniform mat3 uMatrix;
uniform vec3 uOffset;       // for coordinates that may be negative
uniform int uComponent;     // 0, 1, 2; 3 shows all three as red, green, blue
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 space = uMatrix * texture(uImageUnit, vST).rgb + uOffset;
    fColor = vec4(clamp(uComponent < 3 ? vec3(space[uComponent]) : space, 0., 1.), 1.);
}
