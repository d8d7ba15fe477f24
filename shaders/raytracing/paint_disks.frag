// Gx16.6 Two disks of paint that overlap; left their paints are added, right each gives a half.
#version 330
#include "mixing.glsl"

uniform vec4 uFirst, uSecond;
uniform float uAspect;  // width / height of the picture

in vec2 vST;
out vec4 fColor;

/// Paints share the place on the canvas: there is half of each, not all of both.
vec3 mixedFairly(vec3 a, vec3 b) {
    return lightOf(.5 * (paintOf(a) + paintOf(b)));
}

void main() {
    vec2 place = vec2((fract(2. * vST.s) - .5) * uAspect / 2., vST.t - .5);
    bool first = length(place - vec2(0., .12)) < .25, second = length(place + vec2(0., .12)) < .25;
    vec3 color = vec3(1.);
    if (first && second)
        color = vST.s < .5 ? mixed(uFirst.rgb, uSecond.rgb, kPaint) : mixedFairly(uFirst.rgb, uSecond.rgb);
    else if (first) color = uFirst.rgb;
    else if (second) color = uSecond.rgb;
    fColor = vec4(color, 1.);
}
