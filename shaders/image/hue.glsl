// Hue, saturation, value. The hue counts turns of the circle of colours, 0 to 1 from red over green and blue.
vec3 toHsv(vec3 rgb) {
    float largest = max(rgb.r, max(rgb.g, rgb.b));
    float span = largest - min(rgb.r, min(rgb.g, rgb.b));
    if (span <= 0.) return vec3(0., 0., largest);
    float hue = rgb.r == largest ? (rgb.g - rgb.b) / span
              : rgb.g == largest ? 2. + (rgb.b - rgb.r) / span
                                 : 4. + (rgb.r - rgb.g) / span;
    return vec3(fract(hue / 6.), span / largest, largest);
}

vec3 toRgb(vec3 hsv) {
    vec3 hue = clamp(abs(fract(hsv.x + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
    return hsv.z * mix(vec3(1.), hue, hsv.y);
}

// How far apart two hues are, 0 to .5.
float hueDistance(float a, float b) {
    float d = abs(fract(a - b));
    return min(d, 1. - d);
}
