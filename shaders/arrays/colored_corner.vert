// V02 Colour cube: a corner and its colour, which all faces at this corner share.
#version 330

uniform mat4 mvpMatrix;

in vec3 aCorner, aColor;
out vec3 vColor;

void main() {
    vColor = aColor;
    gl_Position = mvpMatrix * vec4(aCorner, 1.);
}
