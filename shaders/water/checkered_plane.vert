// G15.1 Checkered plane: texture coordinates from 0 to 1.
#version 410 core

uniform mat4 mvp_matrix;

in vec3 vertPos;
in vec2 texCoord;
out vec2 vST;

void main() {
    vST = texCoord;
    gl_Position = mvp_matrix * vec4(vertPos, 1.);
}
