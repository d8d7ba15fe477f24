// G17.3 Lens: the whole viewport.
#version 430 core

in vec4 vertPos;
in vec2 tc;
out vec2 vST;

void main() {
    vST = tc;
    gl_Position = vertPos;
}
