// D07 Enneper's surface: the two sides in two colours, with lines of equal parameters.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uFrontColor, uBackColor;
uniform bool uLines;

in vec2 vUV;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 7., 4.);   // eye space

void main() {
    vec3 normal = normalize(vNormal);
    vec3 color = dot(normal, vPosition) < 0. ? uFrontColor : uBackColor;
    if (uLines) {
        vec2 parameter = vUV * 5.;
        vec2 toLine = abs(fract(parameter + .5) - .5) / max(fwidth(parameter), vec2(1e-5));
        color *= mix(.45, 1., smoothstep(.6, 1.6, min(toLine.x, toLine.y)));
    }
    fColor = vec4(adsLight(color, normal, vPosition, kLight, 40.), 1.);
}
