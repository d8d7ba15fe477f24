// Hands on the texture coordinates of a tile.
#version 400 core

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texCoord;
uniform mat4 mvp;
out vec2 vST;

void main() {
    vST = texCoord;
    gl_Position = mvp * vec4(position, 1.);
}
