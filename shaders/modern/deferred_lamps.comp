// Deferred shading: the lamps at a moment. Each has its own circle, speed and hue.
#version 430 core
layout(local_size_x = 64) in;

struct Lamp {
    vec4 place, color;
};

layout(std430) writeonly buffer Lamps { Lamp lamps[]; };
uniform float uTime;

float randomOf(uint i, uint which) {
    uint x = i * 747796405u + which * 2891336453u;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return float((x ^ (x >> 16)) >> 8) / 16777216.;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(lamps.length())) return;
    float radius = 6. * sqrt(randomOf(i, 1u)), speed = mix(-.6, .6, randomOf(i, 2u));
    float angle = 6.2831853 * randomOf(i, 3u) + speed * uTime, hue = randomOf(i, 4u);
    vec3 color = clamp(abs(6. * fract(hue + vec3(0., 2., 1.) / 3.) - 3.) - 1., 0., 1.);
    lamps[i] = Lamp(vec4(radius * cos(angle), .2 + 1.3 * randomOf(i, 5u), radius * sin(angle), 1.), vec4(color, 1.));
}
