// SH116 Oil slick: a film of thickness d = H exp(-A r^2) brightens the wavelengths 2 d eta / (m + 1/2).
#version 330 core

#include "../common/rainbow.glsl"

uniform float uMaxHeight;   // nanometres
uniform float uNoiseMag;
uniform float uA;

in vec2 vXY;

out vec4 fColor;

const float kEta = 1.4;   // index of refraction of oil
const float kShortest = 400., kLongest = 700.;   // nanometres

void main() {
    vec4 octaves = texture(Noise3, vec3(.3 * vXY, .3));
    float noise = octaves.r + octaves.g + octaves.b + octaves.a - 2.;
    vec4 grain = texture(Noise3, vec3(4. * vXY, .7));
    float road = .10 + .5 * (grain.r + grain.g + grain.b + grain.a - 2.);

    float r2 = dot(vXY, vXY) + .35 * uNoiseMag * noise;
    float thickness = uMaxHeight * exp(-uA * max(r2, 0.));

    vec3 sum = vec3(0.);
    int count = 0;
    for (int m = 0; m < 12; ++m) {
        float lambda = 2. * thickness * kEta / (float(m) + .5);
        if (lambda < kShortest) break;
        if (lambda > kLongest) continue;
        float nearEnd = min(lambda - kShortest, kLongest - lambda) / 60.;   // colours fade at both ends of the visible range
        sum += clamp(nearEnd, 0., 1.) * rainbow((lambda - kShortest) / (kLongest - kShortest));
        ++count;
    }
    vec3 film = count > 0 ? sum / float(count) : vec3(0.);
    fColor = vec4(clamp(road, .02, .3) + .62 * film, 1.);
}
