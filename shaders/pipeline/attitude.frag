// Gx3.3 Quaternions: one colour in diffuse light from above.
#version 410 core

uniform vec4 uColor;

in vec3 vNormal;
out vec4 fColor;

void main() {
    float light = .35 + .65 * max(dot(normalize(vNormal), normalize(vec3(1., 3., 2.))), 0.);
    fColor = vec4(light * uColor.rgb, 1.);
}
