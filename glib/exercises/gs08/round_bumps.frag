// Exercise EX8.5: diffuse light of each fragment, to be made Phong's light.
#version 330 core

uniform bool uPhong;
uniform vec3 uLight;     // eye space, as the others
uniform vec3 uColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(uLight - vPosition);
    float diffuse = max(dot(normal, toLight), 0.);
    vec3 color = diffuse * uColor;
    if (uPhong) color = diffuse * uColor;   // Change this.
    fColor = vec4(color, 1.);
}
