// Start, the pass: diffuse light from one side.
#version 430 core

uniform vec3 uColor;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 toLight = normalize(vec3(4., 6., 5.) - vPlace);
    float diffuse = max(dot(normalize(vNormal), toLight), 0.);
    fColor = vec4(uColor * (.35 + .75 * diffuse), 1.);
}
