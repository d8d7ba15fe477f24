// The number of iterations up to MOST at a place of the Mandelbrot set: directly, in NUMBER and VEC2, or as the difference
// from the orbit of the centre (PERTURBED).
#ifdef PERTURBED
uniform float uSpacing;
uniform vec2 uOrbit[MOST];
vec4 value() {
    vec2 c = uSpacing * given(0).xy, d = vec2(0);
    int i = 0;
    for (; i < MOST; ++i) {
        vec2 all = uOrbit[i] + d;
        if (dot(all, all) > 4.) break;
        vec2 sum = uOrbit[i] + all;
        d = vec2(sum.x * d.x - sum.y * d.y, sum.x * d.y + sum.y * d.x) + c;
    }
    return vec4(i);
}
#else
uniform VEC2 uCentre;
uniform NUMBER uSpacing;
vec4 value() {
    VEC2 c = uCentre + uSpacing * VEC2(given(0).xy), z = VEC2(0);
    int i = 0;
    for (; i < MOST; ++i) {
        NUMBER xx = z.x * z.x, yy = z.y * z.y;
        if (xx + yy > 4.) break;
        z = VEC2(xx - yy, 2. * z.x * z.y) + c;
    }
    return vec4(i);
}
#endif
