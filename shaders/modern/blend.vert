// G14.2m Blending: a rectangle of the window. Corners are in 0..1.
#version 430 core

uniform vec2 uLower, uSize;

in vec2 texCoord;
out vec2 vST;

void main() {
    vST = texCoord;
    gl_Position = vec4(2. * (uLower + uSize * texCoord) - 1., 0., 1.);
}
