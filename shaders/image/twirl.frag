// SH059 Twirl: inside the radius uR the picture is turned, by uD degrees at the centre, less and less towards the rim.
#version 330 core

uniform float uD;
uniform float uR;   // picture widths
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 fromCentre = vST - .5;
    float r = length(fromCentre);
    if (r < uR) {
        // A rotation matrix needs no angle of the point itself, so the centre is no special case.
        float turn = radians(uD) * (uR - r) / uR;
        fromCentre = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * fromCentre;
    }
    fColor = vec4(texture(uImageUnit, fromCentre + .5).rgb, 1.);
}
