// Coulomb: a square raised to the sum of Q / distance over three charges, which are x, y and Q.
#version 330 core

uniform vec3 uCharges[3];   // x, y, Q
uniform float uVertical;    // height per unit of the sum
uniform float uSoft;        // the least distance, so that no peak is infinite

out float vSum;
out vec3 vPosition;   // eye space

void main() {
    vSum = 0.;
    for (int i = 0; i < 3; ++i) vSum += uCharges[i].z / max(length(aVertex.xy - uCharges[i].xy), uSoft);
    vec4 raised = vec4(aVertex.xy, uVertical * vSum, 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
