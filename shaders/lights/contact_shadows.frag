// Gx8.5 Penumbra by the distance of the blocker (Fernando 2005): one search finds what is in the way, the next softens.
#version 410 core
#include "../modern/lighting.glsl"

uniform sampler2DShadow uShadow;
uniform sampler2D uDepths;      // the same map, not compared
uniform float uNear, uFar;      // of the light's camera
uniform float uWindow;          // side of what it sees at the distance 1
uniform float uLampSize;
uniform bool uByDistance;
uniform int uSamples;           // in each direction

in vec3 vPlace, vNormal;
in vec4 vShadow;
out vec4 fColor;

/// The distance along the light's axis that has this depth.
float distanceOf(float depth) {
    return uNear * uFar / (uFar - depth * (uFar - uNear));
}

vec2 cell(int i) {
    return (vec2(i % uSamples, i / uSamples) + .5) / float(uSamples) - .5;
}

float litShare() {
    vec3 place = vShadow.xyz / vShadow.w;
    float receiver = distanceOf(place.z);
    int count = uSamples * uSamples;

    // How the depth of this surface changes across the map, so that a flat receiver does not block itself.
    vec3 right = dFdx(place), up = dFdy(place);
    float area = right.x * up.y - right.y * up.x;
    vec2 slope = vec2(up.y * right.z - right.y * up.z, right.x * up.z - up.x * right.z);
    slope = clamp(slope / (abs(area) < 1e-12 ? 1e-12 : area), -2., 2.);

    // The mean distance of what is nearer to the lamp, where the lamp as seen from here crosses the map's plane.
    float search = uLampSize / uWindow / receiver * (receiver - uNear) / uNear;
    search = min(search, .06);
    float sum = 0., blockers = 0.;
    for (int i = 0; i < count; ++i) {
        vec2 offset = search * cell(i);
        float blocker = distanceOf(texture(uDepths, place.xy + offset).r);
        if (blocker < distanceOf(place.z + dot(slope, offset)) - .04) {
            sum += blocker;
            ++blockers;
        }
    }
    if (blockers == 0.) return 1.;

    // Similar triangles: lamp, blocker, penumbra; then its size in the map.
    float blocker = sum / blockers;
    float penumbra = uByDistance ? uLampSize * (receiver - blocker) / blocker : .25 * uLampSize;
    float side = max(penumbra / receiver / uWindow, 1. / float(textureSize(uDepths, 0).x));
    float lit = 0.;
    for (int i = 0; i < count; ++i) {
        vec2 offset = side * cell(i);
        lit += texture(uShadow, vec3(place.xy + offset, place.z + dot(slope, offset) - .0015));
    }
    return lit / float(count);
}

void main() {
    vec3 normal = normalize(vNormal), toLight = normalize(light.position - vPlace);
    fColor = vec4(ambientLight() + litShare() * diffuseLight(normal, toLight), 1.);
}
