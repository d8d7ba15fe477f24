// Points sized by data: each point reads a value at its place, which gives its size and its colour.
#version 330 core

#include "../common/rainbow.glsl"

uniform float uLow, uHigh;        // smaller and larger values are not shown
uniform float uSmall, uLarge;     // diameters in pixels at both ends

out vec3 vColor;

// Hot in one place, cold in another.
float valueAt(vec3 p) {
    vec3 hot = p - vec3(.45, .35, .2), cold = p - vec3(-.5, -.3, -.2);
    return .5 + .5 * exp(-3. * dot(hot, hot)) - .5 * exp(-3. * dot(cold, cold));
}

void main() {
    float t = (valueAt(aVertex.xyz) - uLow) / (uHigh - uLow);
    vColor = rainbow(t);
    gl_PointSize = mix(uSmall, uLarge, pow(clamp(t, 0., 1.), 3.));
    gl_Position = uModelViewProjectionMatrix * aVertex;
    if (t < 0. || t > 1.) gl_Position = vec4(2., 2., 2., 1.);   // out of sight
}
