// G11.f9 A surface in two colours of squares, the same from both sides, in light from above.
#version 410 core

uniform vec3 cameraPosition;
uniform float uCells;

in vec3 vPlace, vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    vec3 toEye = normalize(cameraPosition - vPlace), normal = normalize(vNormal);
    if (dot(normal, toEye) < 0.) normal = -normal;
    vec3 toLight = normalize(vec3(1., 2.5, 1.5));
    vec2 cell = floor(uCells * vST);
    vec3 color = mod(cell.x + cell.y, 2.) == 0. ? vec3(.30, .52, .78) : vec3(.42, .64, .88);
    float specular = pow(max(dot(normal, normalize(toLight + toEye)), 0.), 60.);
    fColor = vec4((.3 + .7 * abs(dot(normal, toLight))) * color + .3 * specular, 1.);
}
