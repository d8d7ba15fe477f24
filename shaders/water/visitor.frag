// Gx15.1 Gx15.2 Gx15.3 Something striped; under water with bands of light on its upper side.
#version 410 core
#include "caustics.glsl"

uniform vec3 uSun, cameraPosition;
uniform vec4 uFog, uFirst, uSecond;
uniform float uStripes;
uniform bool isAbove;

in vec3 vPlace, vNormal, vModelPlace;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    // Stripes like those of a ball, from pole to pole.
    float around = uStripes * atan(vModelPlace.z, vModelPlace.x) / 6.2831853;
    vec3 color = mix(uFirst, uSecond, step(.5, fract(around))).rgb;
    color *= .5 + .5 * max(dot(normal, normalize(uSun)), 0.);
    if (vPlace.y < 0.) color += causticLight(vPlace.xz) * smoothstep(-.4, .6, normal.y);
    if (!isAbove) color = mix(color, uFog.rgb, 1. - pow(clamp((300. - distance(cameraPosition, vPlace)) / 290., 0., 1.), 5.));
    fColor = vec4(min(color, 1.), 1.);
}
