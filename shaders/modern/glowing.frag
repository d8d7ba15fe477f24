// A surface that also sends out light: uGlow times its colour, which may be far above 1.
#version 430 core

uniform vec3 uColor;
uniform float uGlow;

in vec3 vNormal;
out vec4 fColor;

void main() {
    float diffuse = max(dot(normalize(vNormal), normalize(vec3(1., 2., 3.))), 0.);
    fColor = vec4((uGlow + .1 + .6 * diffuse) * uColor, 1.);
}
