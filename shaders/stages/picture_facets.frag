// G12.3 The picture on the ground, and light by the slope of each triangle.
#version 410 core

uniform sampler2D heightMap;
uniform vec3 uLight;

in vec3 vPlace;
in vec2 vST;
out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
    fColor = vec4((.15 + .85 * max(dot(normal, normalize(uLight - vPlace)), 0.)) * vec3(.4 + 1.4 * texture(heightMap, vST).r), 1.);
}
