// R44 Drift: a pattern of noise that moves through the surface.
#version 330 core

uniform int uKind;          // 0 on and off, 1 threshold, 2 translation
uniform float uTime;
uniform vec3 uOn, uOff;

in vec3 vPlace;
in vec3 vNormal;

out vec4 fColor;

float noise(vec3 place) {
    return (dot(texture(Noise3, place), vec4(1.)) - 1.7) / .6;
}

void main() {
    float light = .35 + .65 * max(dot(normalize(vNormal), normalize(vec3(.5, .7, .8))), 0.);
    vec3 color = uOn;
    if (uKind == 0) {
        color = fract(uTime) < .5 ? uOn : uOff;
    } else if (uKind == 1) {
        // The threshold rises and falls; what is below it is gone, and its edge glows.
        float threshold = .5 - .25 * cos(6.2831853 * uTime / 4.);
        float left = noise(.2 * vPlace) - threshold;
        if (left < 0.) discard;
        color = mix(vec3(1., .55, .1), uOn, smoothstep(0., .08, left));
    } else {
        color = mix(uOff, uOn, smoothstep(.35, .65, noise(.2 * vPlace + vec3(.1, 0., 0.) * uTime)));
    }
    fColor = vec4(color * light, 1.);
}
