// R27 The same light without any approximation: three far lights by Lambert's law.
#version 330 core

uniform vec3 uSun[3], uSunColor[3];   // world space
uniform mat4 inverseView;
uniform vec3 uColor;

in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 n = normalize(mat3(inverseView) * vNormal), light = vec3(0.);
    for (int i = 0; i < 3; ++i) light += max(dot(n, normalize(uSun[i])), 0.) * uSunColor[i];
    fColor = vec4(uColor * light, 1.);
}
