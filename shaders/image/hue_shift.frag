// SH049 Hue shift: converts red, green, blue to hue, saturation, value, shifts the hue, and converts back.
#version 330 core

uniform float uT;   // degrees
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

// Hue in turns 0..1, saturation, value.
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

void main() {
    vec3 hsv = toHsv(texture(uImageUnit, vST).rgb);
    hsv.x = fract(hsv.x + uT / 360.);
    fColor = vec4(toRgb(hsv), 1.);
}
