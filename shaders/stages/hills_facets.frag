// G12.5b Hills: each triangle by its own slope, so that one sees how coarse they are.
#version 410 core

uniform vec3 uSun;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
    fColor = vec4((.25 + .75 * max(dot(normal, normalize(uSun)), 0.)) * vec3(.70, .74, .62), 1.);
}
