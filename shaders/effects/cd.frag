// SH114 Compact disc: light of wavelength lambda is bright where the path difference d |T.L + T.E| is m lambda.
#version 330 core

#include "../common/rainbow.glsl"

uniform float uD;   // distance of the tracks, nanometres
uniform float uLightX, uLightY, uLightZ;   // eye space

in vec2 vXY;
in vec3 vPosition;

out vec4 fColor;

const float kShortest = 400., kLongest = 700.;   // nanometres

void main() {
    float r = length(vXY);
    if (r < .125) discard;   // the hole
    vec3 toEye = normalize(-vPosition);
    vec3 toLight = normalize(vec3(uLightX, uLightY, uLightZ) - vPosition);
    vec3 normal = normalize(uNormalMatrix * vec3(0., 0., 1.));
    float diffuse = abs(dot(normal, toLight));

    if (r < .36 || r > .975) {   // clear plastic around the hole and along the rim
        float edge = abs(r - .30) < .012 || r < .15 ? .55 : .30;
        fColor = vec4(vec3(edge * (.4 + .6 * diffuse)), .75);
        return;
    }

    vec3 tangent = normalize(mat3(uModelViewMatrix) * vec3(-vXY.y, vXY.x, 0.));
    float delta = uD * abs(dot(tangent, toLight) + dot(tangent, toEye));
    int first = int(ceil(delta / kLongest)), last = int(floor(delta / kShortest));
    vec3 sum = vec3(0.);
    int count = 0;
    for (int m = max(first, 1); m <= min(last, 12); ++m, ++count) {
        float lambda = delta / float(m);
        sum += rainbow((lambda - kShortest) / (kLongest - kShortest));
    }
    vec3 diffracted = count > 0 ? sum / float(count) : vec3(0.);

    float mirror = pow(abs(dot(normalize(toLight + toEye), normal)), 60.);
    float white = 1. - smoothstep(0., .55 * kShortest, delta);   // order 0: all colours together
    fColor = vec4(.16 + .10 * diffuse + .75 * diffracted + .5 * white + .4 * vec3(mirror), 1.);
}
