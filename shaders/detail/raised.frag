// G10.4 Gx10.2 Colours by height, shaded by the slope of the map; or red where the surface differs from the map.
#version 410 core

uniform sampler2D uHeights;
uniform float uFlatness;
uniform bool uFaults;

in vec2 vST;
in float vHeight;
out vec4 fColor;

void main() {
    float height = texture(uHeights, vST).r;
    vec2 texel = 1. / vec2(textureSize(uHeights, 0));
    float east = texture(uHeights, vST + vec2(texel.x, 0.)).r - texture(uHeights, vST - vec2(texel.x, 0.)).r;
    float north = texture(uHeights, vST + vec2(0., texel.y)).r - texture(uHeights, vST - vec2(0., texel.y)).r;
    vec3 normal = normalize(vec3(-east / (4. * texel.x * uFlatness), 1., north / (4. * texel.y * uFlatness)));
    float light = .35 + .65 * max(dot(normal, normalize(vec3(-2., 3., 1.5))), 0.);
    vec3 color = mix(vec3(.16, .42, .13), vec3(.55, .45, .30), smoothstep(.05, .5, vHeight));
    color = mix(color, vec3(.95), smoothstep(.6, .85, vHeight));
    if (uFaults) {
        color = mix(vec3(.80), vec3(.85, .08, .05), smoothstep(.01, .1, abs(height - vHeight)));
        light = .5 + .5 * light;
    }
    fColor = vec4(light * color, 1.);
}
