// EX16.10 EX16.12 Circles with other powers, in integers: x and y are odd multiples of uFractions / 128, so that every driver agrees.
#version 330 core

uniform int uFractions;   // side of a pixel
uniform int uPower;
uniform int uRamp;

out vec4 fColor;

vec3 ramp(float t) {
    if (uRamp == 0) return clamp(abs(fract(t + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
    if (uRamp == 1) return clamp(3. * t - vec3(0., 1., 2.), 0., 1.);
    if (uRamp == 2) return mix(vec3(.02, .08, .25), vec3(.75, 1., .95), t * t);
    return vec3(t);
}

void main() {
    uvec2 place = uint(uFractions) * (2u * uvec2(gl_FragCoord.xy) + 1u);   // in 1/128
    uvec2 power = uvec2(1u);
    for (int i = 0; i < uPower; ++i) power *= place;   // modulo 2^32
    uint c = (power.x + power.y) >> uint(7 * uPower);
    if ((c & 1u) == 1u) discard;
    fColor = vec4(ramp(float(c % 360u) / 359.), 1.);
}
