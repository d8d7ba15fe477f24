// SH059 Twirl: inside the radius uR the picture is rotated, by uD degrees at the centre and less toward the rim.
#version 330 core

uniform float uD;
uniform float uR;   // in widths of the picture
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 fromCentre = vST - .5;
    float r = length(fromCentre);
    if (r < uR) {
        // A rotation matrix does not need the angle of the point, so the centre is not a special case.
        float turn = radians(uD) * (uR - r) / uR;
        fromCentre = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * fromCentre;
    }
    fColor = vec4(texture(uImageUnit, fromCentre + .5).rgb, 1.);
}
