// G9.2 Sky: the cube map in the direction of the view.
#version 430 core

uniform samplerCube uSky;

in vec3 vDirection;
out vec4 fColor;

void main() {
    fColor = texture(uSky, vDirection);
}
