// Gx10.4 Hills in the sun: the slope of the height map gives the normal, the shadow map says what the sun reaches.
#version 410 core

uniform sampler2D uHeights;
uniform sampler2DShadow uShadow;
uniform float uHeight;
uniform vec3 uSun;
uniform bool uShadows;

in vec2 vST;
in vec4 vSunPlace;
out vec4 fColor;

void main() {
    float height = texture(uHeights, vST).r;
    vec2 texel = 1. / vec2(textureSize(uHeights, 0));
    float east = texture(uHeights, vST + vec2(texel.x, 0.)).r - texture(uHeights, vST - vec2(texel.x, 0.)).r;
    float north = texture(uHeights, vST + vec2(0., texel.y)).r - texture(uHeights, vST - vec2(0., texel.y)).r;
    // The map is two units wide; t grows toward -z.
    vec3 normal = normalize(vec3(-uHeight * east / (4. * texel.x), 1., uHeight * north / (4. * texel.y)));
    float lit = 0., step = 1. / float(textureSize(uShadow, 0).x);
    for (int i = 0; i < 9; ++i)
        lit += texture(uShadow, vSunPlace.xyz + vec3(step * (vec2(i % 3, i / 3) - 1.), 0.)) / 9.;
    if (!uShadows) lit = 1.;
    vec3 color = mix(vec3(.26, .44, .18), vec3(.60, .50, .36), smoothstep(.05, .5, height));
    color = mix(color, vec3(.95), smoothstep(.6, .85, height));
    fColor = vec4((vec3(.22, .26, .36) + lit * max(dot(normal, normalize(uSun)), 0.) * vec3(.9, .82, .68)) * color, 1.);
}
