// EX16.15 Motion, the masks: white figures on black.
#version 330 core

uniform int uShape;   // heart, ring, letter, checks

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 p = 2.4 * vST - 1.2;
    float inside = 0.;
    if (uShape == 0) {
        float a = dot(p, p) - .55;
        inside = float(a * a * a - p.x * p.x * p.y * p.y * p.y < 0.);
    } else if (uShape == 1) {
        inside = float(abs(length(p) - .7) < .22);
    } else if (uShape == 2) {   // a G
        vec2 q = abs(p);
        bool frame = max(q.x, q.y) < .85 && max(q.x, q.y) > .5;
        bool gap = p.x > .4 && p.y > 0. && p.y < .45;
        bool bar = p.x > .05 && p.x < .85 && abs(p.y + .12) < .15;
        inside = float((frame && !gap) || bar);
    } else {
        ivec2 square = ivec2(floor(4. * vST));
        inside = float((square.x + square.y) & 1);
    }
    fColor = vec4(inside);
}
