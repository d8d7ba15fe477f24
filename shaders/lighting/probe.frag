// R26 A light probe: a court with a sun many times brighter than white; or the same light from everywhere, to check the maps.
#version 330 core
#include "../common/direction.glsl"

uniform samplerCube uSky;
uniform int uProbe;       // 0 court, 1 uniform
uniform vec3 uSun;
uniform float uSunLight;

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 direction = directionAt(vST);
    vec3 court = texture(uSky, direction).rgb;
    court = court * court + uSunLight * smoothstep(.97, .99, dot(direction, normalize(uSun))) * vec3(1., .85, .6);
    fColor = vec4(uProbe == 1 ? vec3(1.) : court, 1.);
}
