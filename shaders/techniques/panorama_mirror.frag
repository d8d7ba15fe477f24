// R19 A mirror that reads a panorama. Levels of detail would show the seam, where s jumps from 1 to 0: level 0 only.
#version 330 core
#include "../common/direction.glsl"

uniform sampler2D uPanorama;
uniform mat4 inverseView;
uniform vec3 uTint;
uniform float uMix;

in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 direction = mat3(inverseView) * reflect(normalize(vPosition), normal);
    vec3 own = uTint * (.3 + .7 * max(dot(normal, normalize(vec3(-1., 2., 2.))), 0.));
    fColor = vec4(mix(own, textureLod(uPanorama, placeOf(direction), 0.).rgb, uMix), 1.);
}
