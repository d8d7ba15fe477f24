// SH118 Lens, the court: the cube map itself.
#version 330 core

uniform samplerCube uRefractUnit;

in vec3 vDirection;

out vec4 fColor;

void main() {
    fColor = vec4(texture(uRefractUnit, vDirection).rgb, 1.);
}
