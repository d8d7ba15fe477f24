// EX16.4 Two rainbows: blue 40, green 41, red 42 degrees from the point opposite the sun; the second bow red 50, green 51.5, blue 53.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler2D uImageUnit;
uniform float uUpDown, uLeftRight;   // the point opposite the sun, in the picture
uniform float uInOut;                // distance from the eye to the picture
uniform float uAlf, uSecond;         // strength of both bows
uniform float uWhere;                // the rain falls above this height

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

float band(float angle, float from, float to) {
    return smoothstep(from - .5, from + .5, angle) * (1. - smoothstep(to - .5, to + .5, angle));
}

void main() {
    vec3 scene = texture(uImageUnit, vST).rgb;
    float angle = degrees(atan(length(vXY - vec2(uLeftRight, uUpDown)), max(uInOut, 1e-3)));
    float rain = smoothstep(uWhere - .25, uWhere + .35, vXY.y);
    // Between both bows no light comes from the drops: Alexander's dark band.
    vec3 light = uAlf * (band(angle, 40., 42.) * rainbow((angle - 40.) / 2.) + .22 * (1. - smoothstep(38., 41., angle)) * smoothstep(15., 40., angle));
    light += uSecond * band(angle, 50., 53.) * rainbow((53. - angle) / 3.);
    vec3 wet = mix(scene, .72 * scene + vec3(.06, .07, .09), rain);
    fColor = vec4(min(wet + rain * light, 1.), 1.);
}
