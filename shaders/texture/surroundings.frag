// SH035 Surroundings: the cube map itself.
#version 330 core

uniform samplerCube uTexUnit;

in vec3 vDirection;

out vec4 fColor;

void main() {
    fColor = vec4(texture(uTexUnit, vDirection).rgb, 1.);
}
