// G14.5 Marble recipe: stripes whose place turbulence moves. The texture does not repeat: the stripes run diagonally.
#version 430 core
#include "noise_recipe.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(rgba8) uniform writeonly image3D uMarble;

uniform float uVeins;       // stripes
uniform float uTurbulence;
uniform float uZoom;        // of the coarsest noise, in texels
uniform float uSharpness;

void main() {
    ivec3 size = imageSize(uMarble), texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, size))) return;
    vec3 p = vec3(texel) / vec3(size);
    float phase = p.x + p.y + p.z + uTurbulence * turbulence(vec3(texel), uZoom, size) / 256.;
    float stripe = logistic(abs(sin(3.14159265 * uVeins * phase)), uSharpness);
    vec3 color = vec3(1.25 * stripe - .2, 1.5 * stripe - .25, 1.25 * stripe - .2);
    imageStore(uMarble, texel, vec4(color, 1.));
}
