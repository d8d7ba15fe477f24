// SH053 Stereo television: the pixels of a checkerboard show by turns what the left and the right eye see.
#version 330 core

uniform sampler2D uLeftUnit;
uniform sampler2D uRightUnit;
uniform int uCell;      // pixels per square, 1 on the screen itself

in vec2 vST;

out vec4 fColor;

void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy) / uCell;
    bool left = (cell.x + cell.y) % 2 == 0;
    fColor = vec4(left ? texture(uLeftUnit, vST).rgb : texture(uRightUnit, vST).rgb, 1.);
}
