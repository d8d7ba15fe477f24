// G4.s10 Topologies: places for numbered vertices, so that each kind of primitive shows what it joins.
#version 410 core

uniform int uCount;     // vertices
uniform int uLayout;    // 0 zigzag, 1 fan, 2 triangles with their neighbours, 3 a strip with its neighbours

vec2 around(float angle, vec2 radius) {
    return radius * vec2(cos(angle), sin(angle));
}

void main() {
    float number = float(gl_VertexID), last = max(float(uCount) - 1., 1.), part = number / last;
    bool even = gl_VertexID % 2 == 0;
    vec2 place = vec2(1.5 * part - .75, (even ? -.5 : .5) + .12 * sin(2.4 * number));
    if (uLayout == 1) {
        float angle = 3.14159265 * (number - 1.) / max(last - 1., 1.);
        place = vec2(0., -.6) + (gl_VertexID == 0 ? vec2(0.) : around(angle, vec2(.82, 1.1)));
    }
    if (uLayout == 2) {
        // Six around a centre: a triangle and the three far corners of its neighbours.
        float center = floor(number / 6.);
        place = vec2(-.3 + 1. * center, 0.) + around(radians(60. * number), even ? vec2(.3) : vec2(.55, .75));
    }
    if (uLayout == 3) {
        // The even ones are the strip, the odd ones beside its edges.
        place = vec2(1.1 * part - .5, gl_VertexID % 4 < 2 ? -.35 : .35);
        if (!even) place = vec2(1.1 * (number - 1.) / last - .5, gl_VertexID % 4 == 3 ? -.8 : .8);
        if (gl_VertexID == 1) place = vec2(-.8, .25);
        if (gl_VertexID == uCount - 1) place = vec2(.8, gl_VertexID % 4 == 3 ? -.1 : .1);
    }
    gl_Position = vec4(place, 0., 1.);
}
