// G14.1 Fog: the farther a place is from the eye, the more of the fog's colour; beyond its end there is nothing else.
#version 410 core

uniform sampler2D heightMap, rock;
uniform float uHeight, uFogStart, uFogEnd;
uniform vec4 uFog;

in vec3 vEyePlace;
in vec2 vST;
out vec4 fColor;

void main() {
    float texel = 1. / float(textureSize(heightMap, 0).x);
    vec2 slope = vec2(texture(heightMap, vST + vec2(texel, 0.)).r - texture(heightMap, vST - vec2(texel, 0.)).r,
                      texture(heightMap, vST + vec2(0., texel)).r - texture(heightMap, vST - vec2(0., texel)).r);
    vec3 normal = normalize(vec3(-uHeight * slope.x, 2. * texel, uHeight * slope.y));
    vec3 color = (.3 + .9 * max(dot(normal, normalize(vec3(-1., 1., .4))), 0.)) * texture(rock, 6. * vST).rgb;
    float clear = clamp((uFogEnd - length(vEyePlace)) / (uFogEnd - uFogStart), 0., 1.);
    fColor = vec4(mix(uFog.rgb, color, clear), 1.);
}
