// SH011 Fuzzy spot light: full light inside the cone, falling smoothly to none across its edge.
#version 330 core

uniform float uAngle;       // of the middle of the edge of the cone, degrees
uniform float uWidth;       // half the width of the edge, degrees
uniform float uLeftRight;   // where the light is aimed, model space
uniform vec3 uColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(0., 2., 2.);   // eye space

void main() {
    vec3 target = vec3(uModelViewMatrix * vec4(uLeftRight, 0., .6, 1.));
    vec3 axis = normalize(target - kLight);
    vec3 toFragment = normalize(vPosition - kLight);
    float inner = cos(radians(max(uAngle - uWidth, 0.)));
    float outer = cos(radians(uAngle + uWidth));
    float inCone = smoothstep(outer, inner, dot(axis, toFragment));   // outer < inner: uWidth > 0

    float diffuse = abs(dot(normalize(vNormal), toFragment));
    fColor = vec4((.12 + .88 * inCone * diffuse) * uColor, 1.);
}
