// Light and opacity along a ray through a density in the unit cube, front to back.
// OFFSET: where in a step the field is sampled, 0 at its start, .5 in its middle.
// KEPT: what a step lets through.
// THRESHOLD, if defined: a ray ends when its transmittance falls below.
// SKIPS, if defined: jumps over empty blocks.
in vec2 vPlace;
uniform sampler3D uField;
uniform sampler3D uBlocks;
uniform vec3 uRight;
uniform vec3 uUp;
uniform vec3 uDirection;
uniform float uSeen;
uniform float uStrength;
uniform float uSteps;
uniform float uBlockCount;
out vec4 fColor;
void main() {
    vec2 place = (vPlace * 2. - 1.) * uSeen;
    vec3 origin = vec3(.5) + place.x * uRight + place.y * uUp;
    vec3 a = -origin / uDirection;
    vec3 b = (1. - origin) / uDirection;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    float enter = max(low.x, max(low.y, low.z));
    float leave = min(high.x, min(high.y, high.z));
    fColor = vec4(0.);
    if (enter >= leave)
        return;
    int count = max(1, int(ceil((leave - enter) * uSteps / sqrt(3.))));
    float stepLength = (leave - enter) / float(count);
    float light = 0.;
    float transmittance = 1.;
    for (int i = 0; i < count; ++i) {
        vec3 p = origin + (enter + (float(i) + OFFSET) * stepLength) * uDirection;
#ifdef SKIPS
        // The other samples keep their places. Only samples that are certainly in the empty block are skipped: up
        // to one before its border, because the border is computed in float.
        vec3 cell = floor(p * uBlockCount);
        if (texelFetch(uBlocks, clamp(ivec3(cell), ivec3(0), ivec3(int(uBlockCount) - 1)), 0).r == 0.) {
            vec3 border = (cell + step(vec3(0.), uDirection)) / uBlockCount;
            vec3 there = (border - p) / uDirection;
            i += max(int(min(there.x, min(there.y, there.z)) / stepLength) - 1, 0);
            continue;
        }
#endif
        float density = texture(uField, p).r;
        float kept = KEPT;
        light += transmittance * (1. - kept) * (.2 + .8 * density);
        transmittance *= kept;
#ifdef THRESHOLD
        if (transmittance < THRESHOLD) break;
#endif
    }
    fColor = vec4(light, 1. - transmittance, 0., 1.);
}
