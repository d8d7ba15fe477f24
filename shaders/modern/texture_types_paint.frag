// What the textures of the panels show: slices of a ball, ramps, faces of a cube and of a die, and a face.
#version 410 core

uniform int uPattern;   // 0: slice, 1: ramp, 2: side of a cube, 3: side of a die, 4: face
uniform float uNumber;  // of the slice, layer or side

in vec2 vST;
out vec4 fColor;

vec3 hue(float turn) {
    return clamp(abs(6.*fract(turn + vec3(0., 2., 1.)/3.) - 3.) - 1., 0., 1.);
}

vec3 sideOfCube() {
    vec2 fromEdge = min(vST, 1. - vST);
    float layer = floor(uNumber/6.);
    return min(fromEdge.x, fromEdge.y) < .1 ? vec3(.1) : hue(uNumber/6. + .08*layer) * (1. - .35*layer);
}

// A bit per place of 3 x 3 for each number of pips.
vec3 sideOfDie() {
    const int kPips[6] = int[6](16, 257, 273, 325, 341, 365);
    vec2 three = 3.6*vST - .3;
    ivec2 place = ivec2(floor(three));
    bool isInside = all(greaterThanEqual(place, ivec2(0))) && all(lessThan(place, ivec2(3)));
    bool isPip = isInside && (kPips[int(uNumber)] >> (3*place.y + place.x) & 1) == 1;
    vec2 fromEdge = min(vST, 1. - vST);
    if (min(fromEdge.x, fromEdge.y) < .03) return vec3(.1);
    return isPip && distance(fract(three), vec2(.5)) < .36 ? vec3(.7, .1, .12) : vec3(.96, .94, .88);
}

vec3 face() {
    vec2 at = 2.*vST - 1.;
    bool isEye = distance(vec2(abs(at.x), at.y), vec2(.35, .3)) < .16;
    bool isMouth = abs(length(at) - .6) < .1 && at.y < -.15;
    if (isEye || isMouth) return vec3(.2, .12, .05);
    return length(at) < .92 ? vec3(1., .83, .2) : vec3(.16, .17, .2);
}

vec3 pattern() {
    switch (uPattern) {
        case 0: return vec3(length(vec3(2.*vST - 1., (2.*uNumber + 1.)/9. - 1.)) < .95 ? 1. : .1);
        case 1: return vST.x * hue(uNumber/6.);
        case 2: return sideOfCube();
        case 3: return sideOfDie();
        default: return face();
    }
}

void main() {
    fColor = vec4(pattern(), 1.);
}
