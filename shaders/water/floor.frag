// Gx15.4 The floor under waves, with bands of light: seen from below, or from above through the surface.
#version 410 core
#include "caustics.glsl"
#include "modern/floor.glsl"

uniform bool isAbove;
uniform vec4 uFog;
uniform float uBend;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 wave = waveNormal(vPlace.xz);
    // Seen from above, the lines are bent; from below, only the light is.
    vec2 shown = vPlace.xz + (isAbove ? 12. * uBend : 0.) * wave.xz;
    vec3 normal = normalize(vec3(0., 1., 0.) + vec3(wave.x, 0., wave.z) * uBend);
    vec3 color = litFloor(tileColor(shown), normal, vPlace);
    color = clamp(color + causticLight(shown), 0., 1.);
    if (!isAbove) color = mix(color, uFog.rgb, 1. - pow(clamp((300. - distance(cameraPosition, vPlace)) / 290., 0., 1.), 5.));
    fColor = vec4(color, 1.);
}
