// Tutorial: ambient and diffuse light from one direction.
#version 330 core

in vec3 vNormal;
in vec4 vColor;

out vec4 fColor;

const vec3 kToLight = vec3(-.6, .5, .6);   // eye space

void main() {
    float diffuse = max(dot(normalize(vNormal), normalize(kToLight)), 0.);
    fColor = vec4((.15 + .85 * diffuse) * vColor.rgb, 1.);
}
