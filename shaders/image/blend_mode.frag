// R60 Blend modes: twenty ways to lay one picture over another.
#version 330 core

uniform int uMode;
uniform float uOpacity;     // of all modes but the last, where it is .5 of the normal one
uniform sampler2D uBaseUnit;
uniform sampler2D uBlendUnit;

in vec2 vST;

out vec4 fColor;

// A number from 0 to 1 for each pixel.
float random(uvec2 pixel) {
    uint h = pixel.x * 0x9E3779B9u ^ pixel.y * 0x85EBCA6Bu;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    h ^= h >> 15;
    return float(h >> 8) / 16777216.;
}

float overlay(float a, float b) {
    return a < .5 ? 2. * a * b : 1. - 2. * (1. - a) * (1. - b);
}

float burn(float a, float b) {
    return a >= 1. ? 1. : b > 0. ? max(1. - (1. - a) / b, 0.) : 0.;
}

float dodge(float a, float b) {
    return a <= 0. ? 0. : b < 1. ? min(a / (1. - b), 1.) : 1.;
}

float softLight(float a, float b) {
    return 2. * a * b + a * a * (1. - 2. * b);
}

void main() {
    vec4 base = texture(uBaseUnit, vST), blend = texture(uBlendUnit, vST);
    // The pictures are opaque; a disc of the base is transparent for the mode that needs it.
    float hole = smoothstep(.30, .31, distance(vST, vec2(.5)));
    vec3 a = base.rgb, b = blend.rgb, c = a;
    float opacity = uOpacity;
    switch (uMode) {
    case 0: c = b; break;                                                               // normal
    case 1: c = (a + b) / 2.; break;                                                    // average
    case 2: c = random(uvec2(vST * 160.)) < .5 ? b : a; break;                          // dissolve
    case 3: c = mix(b, a, hole); break;                                                 // behind
    case 4: c = mix(a, vec3(.8), 1. - hole); break;                                     // clear: the paper is seen
    case 5: c = min(a, b); break;                                                       // darken
    case 6: c = a * b; break;                                                           // multiply
    case 7: c = vec3(burn(a.r, b.r), burn(a.g, b.g), burn(a.b, b.b)); break;            // colour burn
    case 8: c = max(a, b); break;                                                       // lighten
    case 9: c = 1. - (1. - a) * (1. - b); break;                                        // screen
    case 10: c = vec3(dodge(a.r, b.r), dodge(a.g, b.g), dodge(a.b, b.b)); break;        // colour dodge
    case 11: c = vec3(overlay(a.r, b.r), overlay(a.g, b.g), overlay(a.b, b.b)); break;  // overlay
    case 12: c = vec3(softLight(a.r, b.r), softLight(a.g, b.g), softLight(a.b, b.b)); break;  // soft light
    case 13: c = vec3(overlay(b.r, a.r), overlay(b.g, a.g), overlay(b.b, a.b)); break;  // hard light
    case 14: c = a + b; break;                                                          // add
    case 15: c = a - b; break;                                                          // subtract
    case 16: c = abs(a - b); break;                                                     // difference
    case 17: c = 1. - abs(1. - a - b); break;                                           // inverse difference
    case 18: c = a + b - 2. * a * b; break;                                             // exclusion
    default: c = b; opacity *= .5; break;                                               // opacity
    }
    fColor = vec4(mix(a, clamp(c, 0., 1.), opacity), 1.);
}
