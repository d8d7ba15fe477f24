// A surface with flat facets. Exercise: the exact normal of each pixel.
#version 330 core

uniform float uShininess;
uniform vec3 uColor;

in vec2 vXY;
in vec3 vPosition;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 1.);   // eye space

void main() {
    vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));   // Change this.
    vec3 toLight = normalize(kLight - vPosition);
    vec3 toEye = normalize(-vPosition);
    if (dot(normal, toEye) < 0.) normal = -normal;
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((.2 + .8 * diffuse) * uColor + .8 * specular, 1.);
}
