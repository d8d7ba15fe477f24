// R36 A relief: a rosette on a plate with a rim. Its height, from which normals and shadows follow.
float reliefHeight(vec2 st) {
    vec2 p = 2. * st - 1.;
    float r = length(p), angle = atan(p.y, p.x + 1e-6);
    float petals = .5 + .5 * cos(8. * angle);
    float leaf = (1. - smoothstep(.35 + .25 * petals, .4 + .25 * petals, r)) * (.5 + .5 * r) * (.6 + .4 * petals);
    float rim = smoothstep(.74, .79, r) * (1. - smoothstep(.86, .91, r));
    float bead = 1. - smoothstep(.1, .16, r);
    return .09 * leaf + .07 * rim + .06 * bead;
}

vec3 reliefNormal(vec2 st) {
    const float kStep = 1. / 256.;
    float across = reliefHeight(st + vec2(kStep, 0.)) - reliefHeight(st - vec2(kStep, 0.));
    float up = reliefHeight(st + vec2(0., kStep)) - reliefHeight(st - vec2(0., kStep));
    return normalize(vec3(-across, -up, 4. * kStep));
}

// The light from a direction: Lambert's law, and 1 or less where the relief stands in the way.
float reliefLight(vec2 st, vec3 toLight) {
    float light = max(dot(reliefNormal(st), toLight), 0.);
    float height = reliefHeight(st), free = 1.;
    for (int i = 1; i <= 12; ++i) {
        float way = .02 * float(i);
        float over = reliefHeight(st + .5 * way * toLight.xy) - height - way * toLight.z;
        free = min(free, 1. - clamp(40. * over, 0., 1.));
    }
    return light * free;
}
