// Periods decrease from 24 to 1.3 pixels along the direction of 20 degrees. With q(t) = -1/2 for fract(t) < 1/2 and 1/2
// above, `once` is the integral of q and `twice` that of `once`; both are periodic.
in vec2 vPlace;
uniform float uSide;
out vec4 fColor;
float once(float t) { return .5 * abs(fract(t) - .5) - .125; }
float twice(float t) {
    float u = fract(t), v = u - .5;
    return u < .5 ? .125 * u - .25 * u * u : .25 * v * v - .125 * v;
}
float phase() {
    const vec2 direction = vec2(.93969, .34202);
    float size = direction.x + direction.y;
    float t = dot(vPlace, direction) / size;
    return uSide * size * (t / 24. + .5 * (1. / 1.3 - 1. / 24.) * t * t);
}
