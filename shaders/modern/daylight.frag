// A surface in the light of one lamp: ambient and diffuse light and a highlight.
#version 430 core

uniform vec3 cameraPosition;
uniform vec3 uLamp, uColor;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLamp = normalize(uLamp - vPlace), toEye = normalize(cameraPosition - vPlace);
    float diffuse = max(dot(normal, toLamp), 0.);
    float highlight = pow(max(dot(normal, normalize(toLamp + toEye)), 0.), 48.);
    fColor = vec4((.15 + .85 * diffuse) * uColor + .4 * highlight, 1.);
}
