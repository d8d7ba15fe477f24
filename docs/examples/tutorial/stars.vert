// Tutorial: points whose size differs from star to star.
#version 330 core

out float vBrightness;

void main() {
    float random = fract(17. * abs(aVertex.x) + 31. * abs(aVertex.y) + 13. * abs(aVertex.z));
    vBrightness = .3 + .7 * random;
    gl_PointSize = 1. + 2. * random * random;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
