// G10.f15 Colour map of a planet from its height map: sea, plains, mountains and ice.
#version 430 core
#include "noise.glsl"

uniform sampler2D heightMap;

in vec2 vST;
out vec4 fColor;

void main() {
    float height = texture(heightMap, vST).r;
    float latitude = abs(2. * vST.y - 1.) + .08 * gradientNoise(vec3(32. * vST, 0.), 32);
    vec3 plain = mix(vec3(.24, .40, .13), vec3(.62, .52, .33), smoothstep(.15, .3, abs(latitude - .5)));
    vec3 land = mix(plain, vec3(.42, .34, .26), smoothstep(.3, .5, height));
    land = mix(land, vec3(.95), smoothstep(.55, .65, height));
    vec3 color = mix(vec3(.04, .13, .34), land, smoothstep(.02, .08, height));
    fColor = vec4(mix(color, vec3(.93, .95, .97), smoothstep(.82, .88, latitude)), 1.);
}
