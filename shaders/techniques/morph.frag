// R45 A map on the shape in between, with light from the left.
#version 330 core

uniform sampler2D uMap;

in vec3 vNormal;
in vec2 vMap;
out vec4 fColor;

void main() {
    float light = .35 + .75 * abs(dot(normalize(vNormal), normalize(vec3(-1., 1., 2.))));
    fColor = vec4(light * texture(uMap, vMap).rgb, 1.);
}
