// The noise on a plane through its periods: from a texture that the driver filters, from one that the shader filters
// (SHADER_FILTER), or from a function vec4 noise(vec3) that precedes this (FUNCTION).
in vec2 vPlace;
uniform vec3 uCorner, uAcross, uUp;
uniform sampler3D uNoise;
out vec4 fColor;
#if defined SHADER_FILTER
vec4 texel(ivec3 at) { return texelFetch(uNoise, at & (textureSize(uNoise, 0) - 1), 0); }
vec4 row(ivec3 at, float x) { return mix(texel(at), texel(at + ivec3(1, 0, 0)), x); }
vec4 plane(ivec3 at, vec2 share) {
    return mix(row(at, share.x), row(at + ivec3(0, 1, 0), share.x), share.y);
}
vec4 noise(vec3 place) {
    vec3 texels = place * vec3(textureSize(uNoise, 0)), cell = floor(texels), share = texels - cell;
    ivec3 at = ivec3(cell);
    return mix(plane(at, share.xy), plane(at + ivec3(0, 0, 1), share.xy), share.z);
}
#elif !defined FUNCTION
// Texel i stands for the place i / n; in the driver's coordinates it is at (i + 1/2) / n.
vec4 noise(vec3 place) {
    return texture(uNoise, place + .5 / vec3(textureSize(uNoise, 0)));
}
#endif
void main() { fColor = noise(uCorner + vPlace.x * uAcross + vPlace.y * uUp); }
