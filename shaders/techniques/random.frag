// R20 Four random values per texel, from an integer hash of its place.
#version 330 core

uniform int uSeed;

out vec4 fColor;

uint mixed(uint x) {
    x ^= x >> 16; x *= 0x7feb352du;
    x ^= x >> 15; x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

void main() {
    uvec2 place = uvec2(gl_FragCoord.xy);
    uint h = mixed(place.x + 4096u * place.y + 0x9e3779b9u * uint(uSeed + 1));
    fColor = vec4((uvec4(h) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.;
}
