// S26 The picture on the left, the filtered one on the right of a line.
#version 430

uniform sampler2D uPicture, uFiltered;
uniform float uLine, uZoom;
uniform bool uBlocks;

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 st = .5 + (vST - .5) / uZoom;
    vec3 color = vST.s < uLine ? texture(uPicture, st).rgb : texture(uFiltered, st).rgb;
    // The blocks of the groups, as faint squares.
    ivec2 texel = ivec2(st * vec2(textureSize(uPicture, 0)));
    if (uBlocks && vST.s >= uLine && ((texel.x / 8 + texel.y / 8) & 1) == 1) color *= .9;
    fColor = vec4(abs(vST.s - uLine) < .002 ? vec3(1.) : color, 1.);
}
