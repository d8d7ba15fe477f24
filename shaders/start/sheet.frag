// Start, the compute shader: the colour says how high the point is.
#version 430 core

uniform float uHeight;
uniform vec3 uNear;

in float vHeight;
out vec4 fColor;

void main() {
    float part = uHeight > 0. ? .5 + .5 * vHeight / uHeight : .5;
    fColor = vec4(mix(vec3(.05, .2, .45), uNear, part), 1.);
}
