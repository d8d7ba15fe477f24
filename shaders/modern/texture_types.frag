// A grid of 4 x 3 panels, each of which reads a texture of another target.
#version 410 core

uniform sampler1D uRainbow;
uniform sampler2D uVillage;
uniform sampler3D uBall;
uniform samplerCube uCourt;
uniform sampler1DArray uRamps;
uniform sampler2DArray uDice;
uniform samplerCubeArray uLamps;
uniform sampler2DRect uFace;
uniform samplerBuffer uHeights;
uniform sampler2D uStar;
uniform sampler2DMS uStarSamples;
uniform sampler2DArray uStars;
uniform sampler2DMSArray uStarsSamples;
uniform sampler2DShadow uDepths;

in vec2 vST;
out vec4 fColor;

const vec3 kGround = vec3(.16, .17, .2);

// The place on a unit ball that fills the panel, turned so that a corner of the cube around it is in front.
vec3 onBall(vec2 at) {
    vec2 place = 2.2*at - 1.1;
    float rest = 1. - dot(place, place);
    if (rest <= 0.) return vec3(0.);
    vec3 n = vec3(place, sqrt(rest));
    n.yz = vec2(.82*n.y + .57*n.z, .82*n.z - .57*n.y);
    return vec3(.71*n.x + .71*n.z, n.y, .71*n.z - .71*n.x);
}

// Nine slices of the volume, the first one at the top left.
vec3 slices(vec2 at) {
    vec2 cell = floor(3.*at);
    float slice = cell.x + 3.*(2. - cell.y);
    return texture(uBall, vec3(fract(3.*at), (slice + .5)/9.)).r * vec3(.95, .6, .3);
}

vec3 dice(vec2 at) {
    vec2 place = 3.*at - vec2(0., .5);
    float row = floor(place.y);
    return row < 0. || row > 1. ? kGround : texture(uDice, vec3(fract(place), floor(place.x) + 3.*(1. - row))).rgb;
}

vec3 lamps(vec2 at) {
    vec3 direction = onBall(vec2(fract(2.*at.x), 2.*at.y - .5));
    return direction == vec3(0.) ? kGround : texture(uLamps, vec4(direction, floor(2.*at.x))).rgb;
}

vec3 court(vec2 at) {
    vec3 direction = onBall(at);
    return direction == vec3(0.) ? kGround : texture(uCourt, direction).rgb;
}

vec3 bars(vec2 at) {
    int bar = int(at.x * float(textureSize(uHeights)));
    float height = texelFetch(uHeights, bar).r;
    bool isGap = fract(at.x * float(textureSize(uHeights))) < .2;
    return isGap || at.y > height ? kGround : mix(vec3(.2, .4, .7), vec3(.5, .85, .9), height);
}

// The mean of the samples on the left, one of them on the right.
vec3 star(vec2 at) {
    ivec2 texel = ivec2(at * vec2(textureSize(uStarSamples)));
    return at.x < .5 ? texelFetch(uStar, texel, 0).rgb : texelFetch(uStarSamples, texel, 0).rgb;
}

// Two layers side by side: their means above, one sample below.
vec3 stars(vec2 at) {
    ivec3 texel = ivec3(fract(2.*at) * vec2(textureSize(uStarsSamples).xy), int(2.*at.x));
    return at.y > .5 ? texelFetch(uStars, texel, 0).rgb : texelFetch(uStarsSamples, texel, 0).rgb;
}

// How many of eight depths lie in front of a ball.
vec3 contours(vec2 at) {
    float count = 0.;
    for (int i = 0; i < 8; ++i) count += texture(uDepths, vec3(at, (float(i) + .5)/8.));
    return mix(vec3(.95, .9, .75), vec3(.25, .1, .3), count/8.);
}

vec3 panel(int index, vec2 at) {
    switch (index) {
        case 0: return texture(uRainbow, at.x).rgb;
        case 1: return texture(uVillage, at).rgb;
        case 2: return slices(at);
        case 3: return court(at);
        case 4: return texture(uRamps, vec2(at.x, floor(6.*at.y))).rgb;
        case 5: return dice(at);
        case 6: return lamps(at);
        case 7: return texture(uFace, at * vec2(textureSize(uFace))).rgb;
        case 8: return bars(at);
        case 9: return star(at);
        case 10: return stars(at);
        default: return contours(at);
    }
}

void main() {
    vec2 grid = vec2(4., 3.)*vST;
    int index = int(grid.x) + 4*(2 - int(grid.y));
    vec2 at = (fract(grid) - .04)/.92;
    bool isFrame = any(lessThan(at, vec2(0.))) || any(greaterThan(at, vec2(1.)));
    fColor = vec4(isFrame ? vec3(.06, .06, .08) : panel(index, at), 1.);
}
