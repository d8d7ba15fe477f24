// R17 Four maps of a planet at once: day, night, clouds, and where it is wet. All from noise on the sphere, without a seam.
#version 330 core

in vec2 vST;
layout(location = 0) out vec4 fDay;      // alpha: 1 where water shines
layout(location = 1) out vec4 fNight;    // alpha: clouds

float layers(vec3 p, int count) {
    float sum = 0., part = 1.;
    for (int i = 0; i < count; ++i) {
        sum += part * noise1(p);
        p = 2. * p + 17.;
        part *= .5;
    }
    return sum;
}

void main() {
    float around = 6.2831853 * vST.s, f = 3.1415927 * (vST.t - .5);
    vec3 p = vec3(-cos(around) * cos(f), sin(f), sin(around) * cos(f));
    float height = layers(1.7 * p + 3., 5);
    float land = smoothstep(.06, .09, height);
    float north = abs(p.y) + .08 * layers(5. * p, 3);
    float ice = smoothstep(.82, .87, north);
    float dry = smoothstep(-.15, .35, layers(2.5 * p + 40., 3) + .3 - 1.1 * abs(abs(p.y) - .35));
    vec3 ground = mix(vec3(.13, .32, .1), vec3(.62, .5, .28), dry);
    ground = mix(ground, vec3(.42, .36, .3), smoothstep(.3, .5, height));
    vec3 sea = mix(vec3(.02, .08, .24), vec3(.06, .28, .42), smoothstep(-.2, .06, height));
    vec3 day = mix(mix(sea, ground, land), vec3(.93, .95, .97), ice);
    fDay = vec4(day, (1. - land) * (1. - ice));

    // People live near coasts, in clusters.
    float coast = land * (1. - smoothstep(.2, .6, height)) * (1. - ice);
    float towns = smoothstep(-.2, .3, layers(9. * p + 7., 2)) * smoothstep(0., .35, noise1(26. * p));
    float clouds = smoothstep(.02, .5, layers(vec3(2.2, 4., 2.2) * p + 80. + .6 * layers(3. * p, 2), 5));
    fNight = vec4(coast * towns * vec3(1., .82, .45) * 2.5, clouds);
}
