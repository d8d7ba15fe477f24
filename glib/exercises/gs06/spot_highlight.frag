// A lamp with a highlight that shines everywhere. Exercise: its cone.
#version 330 core

uniform vec3 uLight;        // eye space
uniform float uKs;
uniform float uShininess;
uniform vec3 uColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(uLight - vPosition);
    vec3 toEye = normalize(-vPosition);
    float inCone = 1.;      // Change this.

    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((.12 + .88 * diffuse) * uColor + uKs * specular, 1.);
}
