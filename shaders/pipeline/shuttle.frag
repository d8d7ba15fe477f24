// G6.3 Paint of the space plane: white tiles, a dark belly and nose, windows, and a red stripe.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out vec4 fColor;

float inside(vec2 p, vec2 low, vec2 high) {
    vec2 edge = step(low, p) * step(p, high);
    return edge.x * edge.y;
}

void main() {
    // Tiles with dark joints, each a little different.
    vec2 tiles = vST * vec2(64., 48.);
    vec2 joint = step(.06, fract(tiles));
    float shade = .84 + .12 * randomOf(ivec3(floor(tiles), 0), 5u).x;
    vec3 color = vec3(shade) * mix(.75, 1., joint.x * joint.y);
    vec3 dark = vec3(.13, .14, .17) * (shade + .2);

    if (vST.s < .5) {
        // The hull: s is around from below, t from the nose to the tail.
        float around = abs(2. * vST.s - .5), along = vST.t;  // 0 above, .5 below
        if (around > .36 || along < .08) color = dark;
        if (abs(around - .30) < .012 && along > .15) color = vec3(.80, .16, .12);
        // Windows of the cockpit.
        float window = 0.;
        for (int i = 0; i < 3; ++i)
            window += inside(vec2(around, along), vec2(.02 + .055 * float(i), .165 + .01 * float(i)),
                             vec2(.065 + .055 * float(i), .20 + .01 * float(i)));
        if (window > 0.) color = vec3(.10, .20, .32);
        // Doors of the hold.
        if (around < .2 && (abs(along - .36) < .004 || abs(along - .8) < .004)) color = vec3(.4);
        if (around < .005 && along > .36 && along < .8) color = vec3(.4);
    } else if (vST.t < .5) {
        // Wings from above, t = 0 at the trailing edge.
        vec2 wing = vec2(2. * vST.s - 1., 2. * vST.t);
        if (wing.y < .12) color = vec3(.55) * shade;
        if (wing.x > .78 && wing.x < .84) color = vec3(.80, .16, .12);
    } else if (vST.s < .78) {
        if (vST.t > .9) color = dark;
        if (vST.t > .62 && vST.t < .72) color = vec3(.80, .16, .12);
    } else {
        color = dark * 1.6;
    }
    fColor = vec4(color, 1.);
}
