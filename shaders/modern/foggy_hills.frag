// G14.1 Fog: linear in the distance from the eye.
#version 430 core

uniform sampler2D heightMap;
uniform float uHeight, uFogStart, uFogEnd;
uniform vec4 uFog;

in vec3 vEyePlace;
in vec2 vST;
out vec4 fColor;

void main() {
    float texel = 1. / float(textureSize(heightMap, 0).x);
    vec2 slope = vec2(texture(heightMap, vST + vec2(texel, 0.)).r - texture(heightMap, vST - vec2(texel, 0.)).r,
                      texture(heightMap, vST + vec2(0., texel)).r - texture(heightMap, vST - vec2(0., texel)).r);
    vec3 normal = normalize(vec3(-uHeight * slope.x / (4. * texel), 1., uHeight * slope.y / (4. * texel)));
    float light = .3 + .7 * max(dot(normal, normalize(vec3(-1., 1., .4))), 0.);
    vec3 rock = mix(vec3(.34, .31, .27), vec3(.33, .42, .20), smoothstep(.75, .9, normal.y));
    float clear = clamp((uFogEnd - length(vEyePlace)) / (uFogEnd - uFogStart), 0., 1.);
    fColor = vec4(mix(uFog.rgb, light * rock, clear), 1.);
}
