// G15.1 Sky box: the cube map in the direction of view.
#version 410 core

uniform samplerCube uSky;

in vec3 vDirection;
out vec4 fColor;

void main() {
    fColor = texture(uSky, vDirection);
}
