// SH110 LIC in three dimensions: one layer of white noise by an integer hash; uKeep is the share of texels that are not black.
#version 330 core

uniform float uLayer;
uniform float uKeep;

out vec4 fColor;

uint mixed(uint x) {
    x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; x ^= x >> 16;
    return x;
}

void main() {
    uvec2 p = uvec2(gl_FragCoord.xy);
    uint h = mixed(mixed(p.x + 64u * (p.y + 64u * uint(uLayer))) + 17u);
    float keep = float(mixed(h + 5u) >> 8) / 16777216.;
    float grey = uKeep < .999 ? 1. : float(h >> 31);
    fColor = vec4(keep < uKeep ? grey : 0.);
}
