// R13 A lit shape with a texture applied in one of five modes.
#version 330 core
#include "texture_mode.glsl"

uniform int uMode;
uniform vec3 uColor, uConstant;
uniform sampler2D uBadge;

in vec3 vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    float light = .3 + .7 * max(dot(normalize(vNormal), normalize(vec3(-1., 1.5, 2.))), 0.);
    fColor = applyTexture(uMode, vec4(light * uColor, 1.), texture(uBadge, vST), uConstant);
}
