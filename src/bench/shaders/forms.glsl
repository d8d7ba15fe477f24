// Pairs of ways to write a form of which one, SLOWER, is said to take longer. A macro names the pair.

#if defined BRANCH && defined SLOWER
float form(vec2 p) {
    if (fract(37. * p.x + 91. * p.y) > .5) return p.x * p.y + .25;
    else return p.x - .5 * p.y;
}
#elif defined BRANCH
float form(vec2 p) {
    return mix(p.x - .5 * p.y, p.x * p.y + .25, 1. - step(fract(37. * p.x + 91. * p.y), .5));
}
#endif

#if defined LOOP && defined SLOWER
uniform int uFour;
float form(vec2 p) {
    float sum = 0.;
    for (int i = 0; i < uFour; ++i) sum = sum * p.x + p.y + float(i);
    return .01 * sum;
}
#elif defined CONSTANT_LOOP && defined SLOWER
float form(vec2 p) {
    float sum = 0.;
    for (int i = 0; i < 4; ++i) sum = sum * p.x + p.y + float(i);
    return .01 * sum;
}
#elif defined LOOP || defined CONSTANT_LOOP
float form(vec2 p) {
    float sum = p.y;
    sum = sum * p.x + p.y + 1.;
    sum = sum * p.x + p.y + 2.;
    sum = sum * p.x + p.y + 3.;
    return .01 * sum;
}
#endif

#if defined LENGTH && defined SLOWER
float form(vec2 p) {
    vec3 v = vec3(p, .3 - p.x);
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
#elif defined LENGTH
float form(vec2 p) { return length(vec3(p, .3 - p.x)); }
#endif

#if defined DOT && defined SLOWER
float form(vec2 p) { return p.x * p.x + p.y * p.y; }
#elif defined DOT
float form(vec2 p) { return dot(p, p); }
#endif

#if defined NORMALIZE && defined SLOWER
float form(vec2 p) {
    vec3 v = vec3(p, .3 - p.x);
    return (v / sqrt(v.x * v.x + v.y * v.y + v.z * v.z)).x;
}
#elif defined NORMALIZE
float form(vec2 p) { return normalize(vec3(p, .3 - p.x)).x; }
#endif

#if defined COMPARISON && defined SLOWER
float form(vec2 p) {
    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);
    if (v.x > .8) return 0.;
    if (v.y > .7) return 0.;
    if (v.z > .9) return 0.;
    return v.x;
}
#elif defined COMPARISON
float form(vec2 p) {
    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);
    return any(greaterThan(v, vec3(.8, .7, .9))) ? 0. : v.x;
}
#endif

#if defined ANGLE && defined SLOWER
float form(vec2 p) {
    float r = length(p), angle = atan(p.y, p.x), wave = r + .1 * r * r;
    vec2 q = wave * vec2(cos(angle), sin(angle));
    return q.x + .5 * q.y;
}
#elif defined ANGLE
float form(vec2 p) {
    float r = length(p), wave = r + .1 * r * r;
    vec2 q = wave * p / r;
    return q.x + .5 * q.y;
}
#endif

#if defined ZOOM && defined SLOWER
float form(vec2 p) {
    float r = length(p), angle = atan(p.y, p.x), far = r / (r + .7);
    return far * cos(angle) + far * sin(angle);
}
#elif defined ZOOM
float form(vec2 p) {
    vec2 far = p / (sqrt(dot(p, p)) + .7);
    return far.x + far.y;
}
#endif
