// R29 Two more values per vertex, the bent normal and the accessibility, which were computed once.
#version 330 core
#include "balls.glsl"

uniform sampler2D uAccess;
uniform mat4 viewProjection;
uniform ivec2 uGrid;
uniform int uFloorGrid;
uniform float uFloorSize;
uniform bool uFloor;

out vec3 vNormal, vBent;    // world space
out float vAccess;

void main() {
    const float kPi = 3.14159265;
    vec3 place;
    ivec2 texel;
    if (uFloor) {
        ivec2 cell = ivec2(gl_VertexID % uFloorGrid, gl_VertexID / uFloorGrid);
        vNormal = vec3(0., 1., 0.);
        place = uFloorSize * vec3(2. * vec2(cell) / float(uFloorGrid - 1) - 1., 0.).xzy;
        texel = cell + ivec2(0, kBalls);
    }
    else {
        float around = 2. * kPi * float(gl_VertexID % uGrid.x) / float(uGrid.x - 1);
        float up = kPi * (float(gl_VertexID / uGrid.x) / float(uGrid.y - 1) - .5);
        vNormal = vec3(cos(around) * cos(up), sin(up), -sin(around) * cos(up));
        place = ball(gl_InstanceID).xyz + ball(gl_InstanceID).w * vNormal;
        texel = ivec2(gl_VertexID, gl_InstanceID);
    }
    vec4 access = texelFetch(uAccess, texel, 0);
    vAccess = access.r;
    vBent = access.gba;
    gl_Position = viewProjection * vec4(place, 1.);
}
