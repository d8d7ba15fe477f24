// SH105 Colour ramps for t = 0..1.

// Blue, cyan, green, yellow, red.
vec3 rainbow(float t) {
    float band = 4. * clamp(t, 0., 1.);
    return clamp(vec3(band - 2., 2. - abs(band - 2.), 2. - band), 0., 1.);
}

// Black, red, yellow, white.
vec3 heatedObject(float t) {
    return clamp(3. * clamp(t, 0., 1.) - vec3(0., 1., 2.), 0., 1.);
}
