// The fragment stage of the axes that --axes draws, white as in the original program.
#version 410 core

out vec4 fColor;

void main() {
    fColor = vec4(1.0);
}
