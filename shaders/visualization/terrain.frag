// SH108 Terrain: normals from the slopes of the height field; the height decides between sea, green land, brown rock and snow.
#version 330 core

uniform sampler2D uHgtUnit;   // metres in red
uniform float uExag;          // exaggeration of the heights in the lighting
uniform float uLevel1;        // from green to brown, metres
uniform float uLevel2;        // from brown to white
uniform float uTol;           // half the width of both changes
uniform float uLightX, uLightY, uLightZ;   // a direction: x east, y north, z up

in vec2 vST;

out vec4 fColor;

const vec2 kSpan = vec2(579240., 419949.);   // the map's sides in metres
const vec3 kSea = vec3(.10, .26, .48), kGreen = vec3(.22, .42, .16), kBrown = vec3(.47, .35, .22), kSnow = vec3(.95);

float height(vec2 offset) {
    return texture(uHgtUnit, vST + offset).r;
}

void main() {
    // Central differences over two texels, each the mean of three rows or columns.
    vec2 t = 1. / vec2(textureSize(uHgtUnit, 0));
    float east = height(vec2(t.s, -t.t)) + 2. * height(vec2(t.s, 0.)) + height(t);
    float west = height(-t) + 2. * height(vec2(-t.s, 0.)) + height(vec2(-t.s, t.t));
    float north = height(vec2(-t.s, t.t)) + 2. * height(vec2(0., t.t)) + height(t);
    float south = height(-t) + 2. * height(vec2(0., -t.t)) + height(vec2(t.s, -t.t));
    vec2 slope = uExag * vec2(east - west, north - south) / (8. * t * kSpan);

    float here = height(vec2(0.));
    vec3 color = kSea;
    if (here > 0.) {
        color = mix(kGreen, kBrown, smoothstep(uLevel1 - uTol, uLevel1 + uTol, here));
        color = mix(color, kSnow, smoothstep(uLevel2 - uTol, uLevel2 + uTol, here));
    }
    float light = max(dot(normalize(vec3(-slope, 1.)), normalize(vec3(uLightX, uLightY, uLightZ))), 0.);
    fColor = vec4((.2 + 1.15 * light) * color, 1.);
}
