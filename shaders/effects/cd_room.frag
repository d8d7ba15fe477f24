// EX16.1 Compact disc in the court: diffraction as in cd.frag, added to the mirror image of the surroundings.
#version 330 core

#include "../common/rainbow.glsl"

uniform samplerCube uReflectUnit;
uniform float uReflection;
uniform mat4 uToWorld;   // from the eye
uniform float uD;        // distance of the tracks, nanometres
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
    vec3 seen = mat3(uToWorld) * reflect(-toEye, normal);
    // The court stands on y in its pictures; in this scene z points up.
    vec3 room = texture(uReflectUnit, vec3(seen.x, seen.z, -seen.y)).rgb;
    if (r < .36 || r > .975) {   // clear plastic around the hole and along the rim
        fColor = vec4(mix(vec3(.35), room, .3 * uReflection), .75);
        return;
    }

    vec3 tangent = normalize(mat3(uModelViewMatrix) * vec3(-vXY.y, vXY.x, 0.));
    float delta = uD * abs(dot(tangent, toLight) + dot(tangent, toEye));
    int first = int(ceil(delta / kLongest)), last = int(floor(delta / kShortest));
    vec3 sum = vec3(0.);
    int count = 0;
    for (int m = max(first, 1); m <= min(last, 12); ++m, ++count)
        sum += rainbow((delta / float(m) - kShortest) / (kLongest - kShortest));
    vec3 diffracted = count > 0 ? sum / float(count) : vec3(0.);
    float white = 1. - smoothstep(0., .55 * kShortest, delta);   // order 0: all colours together
    fColor = vec4(.04 + uReflection * room + .55 * diffracted + .4 * white, 1.);
}
