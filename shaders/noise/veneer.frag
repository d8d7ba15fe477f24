// Veneer: a board of two sheets from one log, the second one turned over, so that the rings meet as in a mirror.
#version 330 core

uniform vec3 uLightWoodColor;
uniform vec3 uDarkWoodColor;
uniform float uRingFreq;
uniform float uNoiseScale;
uniform float uNoiseMag;
uniform bool uBookmatched;

in vec3 vModel;
in vec3 vNormal;

out vec4 fColor;

void main() {
    // Bookmatched: the place counts from the joint x = 0.
    vec3 place = vec3(uBookmatched ? abs(vModel.x) : vModel.x + 3., vModel.yz);
    vec4 octaves = texture(Noise3, uNoiseScale * place);
    vec3 moved = place + uNoiseMag * (octaves.rgb - .5);
    float distance = length(moved.xz) * uRingFreq + uRingFreq * (sqrt(8. + moved.y) + sqrt(8. + abs(moved.x)));
    float ring = 2. * fract(distance + octaves.r + octaves.g + octaves.b);
    float t = ring > 1. ? 2. - ring : ring;      // from light to dark and back

    float fibre = texture(Noise3, vec3(6. * place.x, .25 * place.y, .5)).r - .5;
    vec3 color = mix(uLightWoodColor, uDarkWoodColor, clamp(.9 * t * t + .5 * fibre, 0., 1.));
    float joint = smoothstep(.0, .012, abs(vModel.x));
    fColor = vec4(color * mix(.55, 1., joint), 1.);
}
