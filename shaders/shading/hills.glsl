// Hills: the sum of four bells, and its slopes.
const vec4 kBells[4] = vec4[4](vec4(-.45, .30, .75, 9.), vec4(.50, .35, .50, 14.), vec4(.15, -.45, .60, 8.),
                               vec4(-.55, -.60, .30, 20.));   // x, y, height, sharpness

float hills(vec2 p) {
    float h = 0.;
    for (int i = 0; i < 4; ++i) {
        vec2 d = p - kBells[i].xy;
        h += kBells[i].z * exp(-kBells[i].w * dot(d, d));
    }
    return h;
}

vec2 hillSlope(vec2 p) {
    vec2 s = vec2(0.);
    for (int i = 0; i < 4; ++i) {
        vec2 d = p - kBells[i].xy;
        s -= 2. * kBells[i].w * d * kBells[i].z * exp(-kBells[i].w * dot(d, d));
    }
    return s;
}
