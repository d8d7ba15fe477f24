// R29 What each vertex sees of the sky: rays about its normal. r: the free share; gba: the mean free direction (bent normal).
#version 330 core
#include "balls.glsl"

uniform int uBalls;       // how many of the balls are there
uniform int uRings;       // rays: rings x 2 rings
uniform ivec2 uGrid;      // vertices of a ball along and around
uniform int uFloorGrid;
uniform float uFloorSize;

out vec4 fAccess;

const float kPi = 3.14159265;

void main() {
    // Row b of the texture holds the vertices of ball b; the rows after the balls hold the floor.
    int vertex = int(gl_FragCoord.x), row = int(gl_FragCoord.y);
    vec3 place, normal;
    if (row < kBalls) {
        float around = 2. * kPi * float(vertex % uGrid.x) / float(uGrid.x - 1);
        float up = kPi * (float(vertex / uGrid.x) / float(uGrid.y - 1) - .5);
        normal = vec3(cos(around) * cos(up), sin(up), -sin(around) * cos(up));
        place = ball(row).xyz + ball(row).w * normal;
    }
    else {
        ivec2 cell = ivec2(vertex, row - kBalls);
        normal = vec3(0., 1., 0.);
        place = uFloorSize * vec3(2. * vec2(cell) / float(uFloorGrid - 1) - 1., 0.).xzy;
    }

    vec3 right = normalize(abs(normal.y) > .9 ? cross(normal, vec3(1., 0., 0.)) : cross(normal, vec3(0., 1., 0.)));
    vec3 back = cross(right, normal);
    vec3 bent = vec3(0.);
    int rays = 0;
    // Equally many rays for equal shares of diffuse light: the cosine is sqrt(1 - u).
    for (int i = 0; i < uRings; ++i)
        for (int k = 0; k < 2 * uRings; ++k) {
            float u = (float(i) + .5) / float(uRings), turn = kPi * (float(k) + .5 * float(i % 2) + .25) / float(uRings);
            vec3 along = sqrt(u) * (cos(turn) * right + sin(turn) * back) + sqrt(1. - u) * normal;
            if (blocked(place + 1e-3 * normal, along, row < kBalls ? row : -1, uBalls)) continue;
            bent += along;
            ++rays;
        }
    fAccess = vec4(float(rays) / float(2 * uRings * uRings), length(bent) > 0. ? normalize(bent) : normal);
}
