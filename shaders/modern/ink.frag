// Ink where the normal or the distance changes from one pixel to the next (Saito and Takahashi 1990).
#version 430 core

uniform sampler2D uTones, uSurfaces;
uniform float uInk;

out vec4 fColor;

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy), last = textureSize(uSurfaces, 0) - 1;
    vec4 here = texelFetch(uSurfaces, place, 0);
    float change = 0.;
    for (int i = 0; i < 4; ++i) {
        ivec2 aside = ivec2(i & 1, i >> 1) * 2 - 1;
        vec4 there = texelFetch(uSurfaces, clamp(place + aside, ivec2(0), last), 0);
        change = max(change, length(there.xyz - here.xyz) + 2. * abs(there.w - here.w));
    }
    vec4 tone = texelFetch(uTones, place, 0);
    fColor = mix(tone, vec4(.05, .05, .1, 1.), uInk * smoothstep(.5, .9, change));
}
