// G4.2b Cloud of cubes: as G4.2, with places that fill a large box.
#version 430 core
#include "transforms.glsl"

uniform mat4 v_matrix, p_matrix;
uniform float uTime;

in vec3 vertPos;
out vec3 vColor;

/// So many millionths of a turn per cube and unit of time. Whole turns are taken off while the number is exact, because
/// sines of large numbers differ between drivers.
float angleOf(uint millionths) {
    uint part = uint(gl_InstanceID) % 1000u * millionths + uint(gl_InstanceID) / 1000u % 1000u * (millionths % 1000u) * 1000u;
    return 6.2831853e-6 * (float(part % 1000000u) + float(millionths) * uTime);
}

void main() {
    vec3 angle = vec3(angleOf(4039u), angleOf(11973u), angleOf(10605u));
    vec3 place = vec3(403. * sin(angle.x), 401. * cos(angle.y), 405. * sin(angle.z));
    float turn = angleOf(278521u);
    mat4 model = translation(place) * rotationY(turn) * rotationX(turn) * rotationZ(turn);
    vColor = .5 * vertPos + .5;
    gl_Position = p_matrix * v_matrix * model * vec4(vertPos, 1.);
}
