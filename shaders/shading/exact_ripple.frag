// SH024 Exact shading: the normal of .3 sin(x^2 + y^2) from its derivatives at the fragment itself.
#version 330 core

uniform float uHeight;
uniform float uShininess;
uniform vec3 uColor;

in vec2 vXY;
in vec3 vPosition;

out vec4 fColor;

const vec3 kLight = vec3(-3., 7., 2.);   // eye space

void main() {
    vec2 slope = 2. * uHeight * cos(dot(vXY, vXY)) * vXY;
    vec3 normal = normalize(uNormalMatrix * vec3(-slope, 1.));
    vec3 toLight = normalize(kLight - vPosition);
    vec3 toEye = normalize(-vPosition);
    if (dot(normal, toEye) < 0.) normal = -normal;

    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((.25 + .75 * diffuse) * uColor + .8 * specular, 1.);
}
