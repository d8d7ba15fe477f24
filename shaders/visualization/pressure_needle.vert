// EX14.2 Pressure, the needles: suction points outward; pressure, which would be hidden inside, ends on the surface from outside.
#version 330 core

uniform float uStretch;

in float aPressure;
in float aTip;

out float vPressure;
out vec3 vNormal;

void main() {
    vPressure = aPressure;
    vNormal = uNormalMatrix * aNormal;
    vec3 tip = aVertex.xyz + aTip * uStretch * abs(aPressure) * aNormal;
    gl_Position = uModelViewProjectionMatrix * vec4(tip, 1.);
}
