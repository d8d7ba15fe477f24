// R47 Wobble: the picture is read at places that four sines move to and fro.
#version 330 core

uniform sampler2D uPicture;
uniform float uAmount, uWaves, uPhase;

in vec2 vST;
out vec4 fColor;

void main() {
    // Mirrored coordinates have no seam at the edges.
    vec2 angle = uWaves * vST.ts + uPhase * vec2(1., 1.3);
    vec2 shift = sin(angle) + .5 * sin(2.3 * angle.yx + .7 * uPhase);
    fColor = vec4(texture(uPicture, vST + uAmount * shift).rgb, 1.);
}
