// R36 Fits six coefficients per texel: least squares over 52 photographs of the relief, each under another light.
#version 330 core
#include "relief.glsl"

in vec2 vST;
layout(location = 0) out vec4 fHigh;   // of lu^2, lv^2, lu lv
layout(location = 1) out vec4 fLow;    // of lu, lv, 1

void main() {
    mat3 squares = mat3(0.);
    vec3 right = vec3(0.);
    float mixedSquare = 0., mixedRight = 0., uSquare = 0., uRight = 0., vRight = 0.;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k) {
            vec2 l = (vec2(i, k) - 3.5) / 4.;
            if (dot(l, l) > .98) continue;
            float seen = reliefLight(vST, vec3(l, sqrt(1. - dot(l, l))));
            vec3 even = vec3(l * l, 1.);
            squares += outerProduct(even, even);
            right += seen * even;
            mixedSquare += l.x * l.x * l.y * l.y;
            mixedRight += seen * l.x * l.y;
            uSquare += l.x * l.x;
            uRight += seen * l.x;
            vRight += seen * l.y;
        }
    // The lights lie symmetrically, so lu, lv and lu lv are orthogonal to everything else.
    vec3 even = inverse(squares) * right;
    fHigh = vec4(even.x, even.y, mixedRight / mixedSquare, 1.);
    fLow = vec4(uRight / uSquare, vRight / uSquare, even.z, 1.);
}
