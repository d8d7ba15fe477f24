// S21 Points in the colours of their coordinates.
#version 400

in vec2 vAt;
out vec4 fColor;

void main() { fColor = vec4(.3 + .7 * vAt.x, .3 + .7 * vAt.y, .8, 1.); }
