// SH097 Point cloud: the value of the field at the point. Points with values outside uMin..uMax are discarded.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uTexUnit;   // 0..100 in red
uniform float uMin, uMax;

in vec3 vModel;

out vec4 fColor;

void main() {
    float value = texture(uTexUnit, (vModel + 1.) / 2.).r;
    if (value < uMin || value > uMax) discard;
    fColor = vec4(rainbow(value / 100.), 1.);
}
