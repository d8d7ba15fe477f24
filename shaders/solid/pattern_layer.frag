// G14.4 G14.4b A layer of a texture in three dimensions: horizontal bands, or cubes of alternating colours.
#version 410 core

uniform int uLayer, uBand;  // band: width in texels
uniform bool uChecker;

out float fWhich;

void main() {
    ivec3 band = ivec3(ivec2(gl_FragCoord.xy), uLayer) / uBand;
    fWhich = float((uChecker ? band.x + band.y + band.z : band.y) & 1);
}
