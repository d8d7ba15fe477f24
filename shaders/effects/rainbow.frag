// SH120 Rainbow: violet at 40 degrees from the point opposite the sun, red at 42, fading over half a degree on both
// sides. The sky inside the bow is a little brighter.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler2D uImageUnit;
uniform float uUpDown, uLeftRight;   // position of the point opposite the sun, in the picture
uniform float uInOut;                // distance from the eye to the picture
uniform float uAlf;                  // strength

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

void main() {
    vec3 scene = texture(uImageUnit, vST).rgb;
    float angle = degrees(atan(length(vXY - vec2(uLeftRight, uUpDown)), max(uInOut, 1e-3)));

    float inBow = smoothstep(39.5, 40.5, angle) * (1. - smoothstep(41.5, 42.5, angle));
    float onSky = smoothstep(-.12, .15, vXY.y);   // no drops in front of the water
    float inside = .12 * smoothstep(20., 40., angle) * (1. - smoothstep(40., 41., angle));
    vec3 bow = rainbow((angle - 40.) / 2.);
    vec3 color = scene + onSky * uAlf * (inside + inBow * bow * .75);
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
