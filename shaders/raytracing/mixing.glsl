// Four ways to mix two colours: as a mean, as light (RGB), as ink (CMY), and as paint (RYB: red, yellow, blue).

float largest(vec3 v) {
    return max(max(v.x, v.y), v.z);
}
float smallest(vec3 v) {
    return min(min(v.x, v.y), v.z);
}

/// From light to paint and back (Sugita and Takahashi 2015). White is taken off first and black put on last. Greys have
/// nothing else: there both sizes are 0, and nothing is scaled.
vec3 paintOf(vec3 rgb) {
    float white = smallest(rgb), black = smallest(1. - rgb);
    vec3 c = rgb - white;
    float yellow = min(c.r, c.g);
    vec3 ryb = vec3(c.r - yellow, .5 * (c.g + yellow), .5 * (c.b + c.g - yellow));
    if (largest(ryb) > 0.) ryb *= largest(c) / largest(ryb);
    return ryb + black;
}
vec3 lightOf(vec3 ryb) {
    float black = smallest(ryb), white = smallest(1. - ryb);
    vec3 c = ryb - black;
    float green = min(c.y, c.z);
    vec3 rgb = vec3(c.x + c.y - green, c.y + green, 2. * (c.z - green));
    if (largest(rgb) > 0.) rgb *= largest(c) / largest(rgb);
    return rgb + white;
}

const int kMean = 0, kLight = 1, kInk = 2, kPaint = 3;

vec3 mixed(vec3 a, vec3 b, int way) {
    if (way == kMean) return .5 * (a + b);
    if (way == kLight) return min(a + b, 1.);
    if (way == kInk) return max(a + b - 1., 0.);
    return lightOf(min(paintOf(a) + paintOf(b), 1.));
}
