// R29 Eight balls on a floor, and what stands in the way of a ray.
const int kBalls = 8;

vec4 ball(int i) {
    const vec4 kBall[8] = vec4[8](
        vec4(0., .8, 0., .8), vec4(1.25, .45, .35, .45), vec4(-1.2, .5, .3, .5), vec4(.45, .35, 1.1, .35),
        vec4(-.45, .25, 1.15, .25), vec4(-.1, .6, -1.4, .6), vec4(1.15, .55, -.7, .55), vec4(-1.2, .4, -.75, .4));
    return kBall[i];
}

// Whether the ray from `from` meets a ball other than number `own`, or the floor.
bool blocked(vec3 from, vec3 along, int own, int balls) {
    if (own >= 0 && along.y < 0.) return true;
    for (int i = 0; i < balls; ++i) {
        vec4 b = ball(i);
        vec3 to = b.xyz - from;
        float ahead = dot(to, along);
        if (i != own && ahead > 0. && dot(to, to) - ahead * ahead < b.w * b.w) return true;
    }
    return false;
}
