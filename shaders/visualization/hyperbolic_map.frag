// SH095 Hyperbolic zoom: a town of blocks and streets with a river, a park and a flag. What is smaller than a pixel fades to its mean.
#version 330 core

in vec2 vPlace;

out vec4 fColor;

// 1 on lines of that half width around whole multiples of `spacing`.
float streets(vec2 p, float spacing, float halfWidth) {
    vec2 wide = fwidth(p);
    vec2 away = abs(p - spacing * floor(p / spacing + .5));
    vec2 on = 1. - smoothstep(halfWidth - .5 * wide, halfWidth + .5 * wide + 1e-6, away);
    on = mix(on, vec2(2. * halfWidth / spacing), smoothstep(.25 * spacing, .6 * spacing, wide));
    return max(on.x, on.y);
}

uint mixed(uint x) {
    x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; x ^= x >> 16;
    return x;
}

void main() {
    vec2 p = vPlace;
    float pixel = max(fwidth(p.x), fwidth(p.y));
    ivec2 block = ivec2(floor(p * 4.));
    float tone = float(mixed(uint(block.x + 128) * 257u + uint(block.y + 128)) >> 8) / 16777216.;
    vec3 color = mix(vec3(.93, .90, .84), vec3(.86, .83, .78), mix(tone, .5, smoothstep(.1, .3, pixel)));
    float park = max(abs(p.x + 1.5) - .72, abs(p.y - 1.25) - .47);
    color = mix(vec3(.66, .82, .56), color, smoothstep(-pixel, pixel, park));
    color = mix(color, vec3(.99), streets(p, .25, .025));
    color = mix(color, vec3(.99, .80, .38), streets(p, 1., .05));
    float river = abs(p.y + .9 + .45 * sin(1.1 * p.x) + .1 * sin(2.7 * p.x)) - .17;
    color = mix(vec3(.55, .74, .90), color, smoothstep(-pixel, pixel, river));
    float flag = length(p - vec2(1.5, 0.)) - .16;
    color = mix(vec3(.85, .10, .10), color, smoothstep(-.5 * pixel, .5 * pixel, flag));
    fColor = vec4(color, 1.);
}
