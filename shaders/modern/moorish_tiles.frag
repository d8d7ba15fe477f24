// EX13.7 Moorish tiles: eight-pointed stars that touch at their tips, and the crosses between them.
#version 430 core

in vec2 vST;
out vec4 fColor;

/// The distance from the edge of a star, which is a square and the same square turned by 45 degrees; below 0 inside.
float fromStar(vec2 p) {
    p = abs(p);
    return min(max(p.x, p.y), (p.x + p.y) / sqrt(2.)) - .5 / sqrt(2.);
}

void main() {
    vec2 place = fract(4. * vST) - .5;
    float d = fromStar(place), edge = 1.5 * max(fwidth(4. * vST.x), fwidth(4. * vST.y));
    vec3 color = d < 0. ? vec3(.10, .24, .52) : vec3(.12, .52, .50);
    color = mix(color, vec3(.86, .62, .20), 1. - smoothstep(.012, .012 + edge, abs(d + .10)));
    color = mix(color, vec3(.92, .90, .84), 1. - smoothstep(-.2, -.2 + edge, d));
    color = mix(color, vec3(.60, .18, .14), 1. - smoothstep(-.28, -.28 + edge, d));
    color = mix(color, vec3(.95, .93, .87), 1. - smoothstep(.02, .02 + edge, abs(d)));
    fColor = vec4(color, 1.);
}
