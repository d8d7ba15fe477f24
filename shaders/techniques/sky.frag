// The sky itself.
#version 330 core

uniform samplerCube uSky;

in vec3 vDirection;
out vec4 fColor;

void main() { fColor = vec4(texture(uSky, vDirection).rgb, 1.); }
