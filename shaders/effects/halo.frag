// EX16.7 Halo of 22 degrees: above its least deviation, each colour fades as 1 / sqrt. Red stands inside, because ice bends it least.
#version 330 core

uniform float uIndex;      // of ice, for yellow light
uniform float uView;       // from the middle of the picture to its edge, degrees
uniform float uStrength;
uniform bool uHand;        // an outstretched arm, for scale

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

float leastDeviation(float n) {
    return 2. * degrees(asin(.5 * n)) - 60.;
}

void main() {
    float angle = degrees(atan(length(vXY) * tan(radians(uView))));
    vec3 edge = vec3(leastDeviation(uIndex - .004), leastDeviation(uIndex), leastDeviation(uIndex + .007));
    // Half a degree of sun blurs the edge.
    vec3 beyond = angle - edge;
    vec3 ring = smoothstep(-.35, .35, beyond) * inversesqrt(1. + max(beyond, 0.) * 1.6) *
                (1. - smoothstep(4., 22., beyond));

    vec4 octaves = texture(Noise3, vec3(vec2(.9, .35) * vST, .2));
    float veil = clamp(.75 + .8 * (octaves.r + octaves.g + octaves.b + octaves.a - 2.), .3, 1.);
    vec3 sky = mix(vec3(.24, .40, .66), vec3(.36, .52, .75), .5 - .5 * vXY.y) + .10 * veil;
    vec3 color = sky - .06 * veil * (1. - smoothstep(edge.g - 3., edge.g + 1., angle)) + .42 * uStrength * veil * ring;
    color += .9 * exp(-angle * angle / 14.) + .25 * exp(-angle / 6.);

    // An arm that hides the light below the sun; its fist is 5 degrees wide.
    if (uHand) {
        vec2 fist = degrees(atan(vXY * tan(radians(uView)))) - vec2(0., -1.);
        float arm = abs(fist.x + .04 * fist.y) - 2.6 - .03 * max(-fist.y, 0.);
        float inArm = 1. - smoothstep(-.15, .15, max(arm, fist.y + 6.));
        color = mix(color, vec3(.10, .09, .09), inArm);
    }
    fColor = vec4(min(color, 1.), 1.);
}
