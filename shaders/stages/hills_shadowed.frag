// Gx12.3 Hills in the sun, with the shadows that they throw on each other.
#version 410 core
#include "hills.glsl"

uniform sampler2DShadow uShadow;
uniform mat4 uToShadow;
uniform vec3 uSun;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = hillNormal(vPlace.xz);
    vec3 place = vec3(uToShadow * vec4(vPlace + .01 * normal, 1.));
    float lit = 0.;
    for (int i = 0; i < 4; ++i)
        lit += .25 * texture(uShadow, place + vec3(vec2(i & 1, i >> 1) - .5, 0.) / vec3(textureSize(uShadow, 0), 1.));
    float light = .25 + .75 * lit * max(dot(normal, normalize(uSun)), 0.);
    fColor = vec4(light * hillColor(normal) * 1.4, 1.);
}
