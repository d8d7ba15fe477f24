// EX12.2 Superquad: corners in eye space, with their colours.
#version 330 core

out vec3 vColor;

void main() {
    vColor = aColor.rgb;
    gl_Position = uModelViewMatrix * aVertex;
}
