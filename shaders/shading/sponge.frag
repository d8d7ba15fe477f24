// Sponge: pores of noise that stay where they are in the material, lit by the normal of what is seen.
#version 330 core

uniform vec3 uColor;

in vec3 vModel;
in vec3 vPosition;

out vec4 fColor;

void main() {
    vec4 octaves = texture(Noise3, .45 * vModel);
    float noise = .5 + 2.5 * (dot(octaves, vec4(1.)) - 2.);
    float pore = smoothstep(.25, .45, noise);
    vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    float light = .35 + .65 * abs(dot(normal, normalize(vec3(-2., 4., 4.))));
    fColor = vec4(light * mix(.45, 1., pore) * uColor, 1.);
}
