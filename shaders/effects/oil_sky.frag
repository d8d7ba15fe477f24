// EX16.1 Oil slick under the sky: interference at the slant, 2 d sqrt(eta^2 - sin^2), and a mirror with Fresnel's share.
#version 330 core

#include "../common/rainbow.glsl"

uniform samplerCube uSkyUnit;
uniform vec3 uEye;          // world
uniform float uMirror;
uniform float uMaxHeight;   // nanometres
uniform float uNoiseMag;
uniform float uA;

in vec2 vXY;

out vec4 fColor;

const float kEta = 1.4;   // index of refraction of oil
const float kShortest = 400., kLongest = 700.;   // nanometres

void main() {
    vec3 toEye = normalize(uEye - vec3(vXY, 0.));
    float cosine = toEye.z;
    float slant = sqrt(kEta * kEta - (1. - cosine * cosine));
    vec3 seen = vec3(-toEye.xy, toEye.z);   // mirrored at the road
    vec3 sky = texture(uSkyUnit, vec3(seen.x, seen.z, -seen.y)).rgb;

    vec4 octaves = texture(Noise3, vec3(.3 * vXY, .3));
    float noise = octaves.r + octaves.g + octaves.b + octaves.a - 2.;
    vec4 grain = texture(Noise3, vec3(4. * vXY, .7));
    float road = clamp(.12 + .4 * (grain.r + grain.g + grain.b + grain.a - 2.), .03, .3);
    float thickness = uMaxHeight * exp(-uA * max(dot(vXY, vXY) + .35 * uNoiseMag * noise, 0.));

    vec3 sum = vec3(0.);
    int count = 0;
    for (int m = 0; m < 12; ++m) {
        float lambda = 2. * thickness * slant / (float(m) + .5);
        if (lambda < kShortest) break;
        if (lambda > kLongest) continue;
        float nearEnd = min(lambda - kShortest, kLongest - lambda) / 60.;
        sum += clamp(nearEnd, 0., 1.) * rainbow((lambda - kShortest) / (kLongest - kShortest));
        ++count;
    }
    vec3 film = count > 0 ? sum / float(count) : vec3(0.);
    float oil = smoothstep(20., 120., thickness);
    float base = (kEta - 1.) / (kEta + 1.);
    float fresnel = mix(base * base, 1., pow(1. - cosine, 5.));
    float wet = mix(.35, 1., oil) * uMirror * mix(.25, 1., fresnel);
    fColor = vec4(road * (1. - wet) + wet * sky + .5 * film * mix(vec3(1.), sky, .5), 1.);
}
