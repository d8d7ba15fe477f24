// G11.f3 A round dot.
#version 410 core

uniform vec4 uColor;

out vec4 fColor;

void main() {
    if (distance(gl_PointCoord, vec2(.5)) > .5) discard;
    fColor = uColor;
}
