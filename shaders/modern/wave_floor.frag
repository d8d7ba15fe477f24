// G15.5 G15.6 G15.8 Floor below waves: they bend the lines of the tiles and the light, and gather it in bright bands.
#version 430 core
#include "waves.glsl"
#include "floor.glsl"

uniform bool isAbove;
uniform vec4 uFog;
uniform float uBend, uCaustics;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 wave = waveNormal(vPlace.xz);
    // Seen from above, the lines are bent; from below, only the light is.
    vec3 color = tileColor(vPlace.xz + (isAbove ? 12. * uBend : 0.) * wave.xz);
    vec3 normal = normalize(vec3(0., 1., 0.) + vec3(wave.x, 0., wave.z) * uBend);
    color = litFloor(color, normal, vPlace);

    float height = waveHeight(vPlace.xz) / uWaveHeight;
    float band = 1. - abs(sin(6.2831853 * height));
    color = clamp(color + uCaustics * band * band * band * band, 0., 1.);

    if (!isAbove) {
        float far = distance(cameraPosition, vPlace);
        color = mix(color, uFog.rgb, 1. - pow(clamp((300. - far) / 290., 0., 1.), 5.));
    }
    fColor = vec4(color, 1.);
}
