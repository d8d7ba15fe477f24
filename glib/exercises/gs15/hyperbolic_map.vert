// Exercise EX7.5: the map without a zoom.
#version 330 core

uniform int uZoom;   // 0: polar, 1: Cartesian, 2: none
uniform float uTransX, uTransY;

out vec2 vPlace;     // on the map

void main() {
    vPlace = aVertex.xy;
    vec2 p = aVertex.xy + vec2(uTransX, uTransY);
    vec2 seen = p / (uZoom == 2 ? 6. : 2.);   // <- write both zooms
    gl_Position = uModelViewProjectionMatrix * vec4(seen, 0., 1.);
}
