// G12.2 Bezier sheet: tiles under a light beside the eye; both sides are lit.
#version 430 core

uniform sampler2D tiles;

in vec3 vPlace, vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    vec3 toEye = normalize(-vPlace), toLight = normalize(vec3(-1., 2., 1.) - vPlace);
    vec3 normal = normalize(faceforward(vNormal, -toEye, vNormal));
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = pow(max(dot(normal, normalize(toLight + toEye)), 0.), 40.);
    fColor = vec4((.2 + .8 * diffuse) * texture(tiles, vST).rgb + .3 * specular, 1.);
}
