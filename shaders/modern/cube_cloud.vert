// G4.2b Cloud of cubes: as G4.2, with places that fill a large box.
#version 430 core
#include "transforms.glsl"

uniform mat4 v_matrix, p_matrix;
uniform float uTime;

in vec3 vertPos;
out vec3 vColor;

void main() {
    float t = gl_InstanceID + uTime;
    vec3 place = vec3(403. * sin(203. * t / 8000.), 401. * cos(301. * t / 4001.), 405. * sin(400. * t / 6003.));
    mat4 model = translation(place) * rotationY(1.75 * t) * rotationX(1.75 * t) * rotationZ(1.75 * t);
    vColor = .5 * vertPos + .5;
    gl_Position = p_matrix * v_matrix * model * vec4(vertPos, 1.);
}
