// SH095 Hyperbolic zoom: polar, r -> r / (r + K); or Cartesian, x -> x / sqrt(x^2 + K^2) and likewise y.
#version 330 core

uniform int uZoom;   // polar, cartesian, none
uniform float uK;
uniform float uTransX, uTransY;

out vec2 vPlace;     // on the map

void main() {
    vPlace = aVertex.xy;
    vec2 p = aVertex.xy + vec2(uTransX, uTransY);
    // The polar form needs no angle: x and y shrink by the same factor.
    vec2 seen = p / 6.;   // -1..1
    if (uZoom == 0) seen = p / (length(p) + uK);
    else if (uZoom == 1) seen = p / sqrt(p * p + uK * uK);
    gl_Position = uModelViewProjectionMatrix * vec4(seen, 0., 1.);
}
