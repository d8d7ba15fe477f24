// Gx17.3 The ground of the Moon: the slope of the height map in the light of a low sun.
#version 410 core

uniform sampler2D heightMap;
uniform float uRelief;
uniform vec3 uSun;

in vec3 vPlace;
in vec2 vST;
out vec4 fColor;

void main() {
    float texel = 1. / float(textureSize(heightMap, 0).x);
    float east = texture(heightMap, vST + vec2(texel, 0.)).r - texture(heightMap, vST - vec2(texel, 0.)).r;
    float north = texture(heightMap, vST + vec2(0., texel)).r - texture(heightMap, vST - vec2(0., texel)).r;
    vec3 normal = normalize(vec3(-uRelief * east, 4. * texel, uRelief * north));
    float grey = .45 + .8 * texture(heightMap, vST).r;
    fColor = vec4((.06 + 1.2 * max(dot(normal, normalize(uSun)), 0.)) * grey * vec3(1., .98, .95), 1.);
}
