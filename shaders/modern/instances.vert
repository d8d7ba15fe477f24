// G4.2 Instances: the number of the instance and the time give each cube its own model matrix.
#version 430 core
#include "transforms.glsl"

uniform mat4 v_matrix, p_matrix;
uniform float uTime, uSpread;

in vec3 vertPos;
out vec3 vColor;

void main() {
    float t = gl_InstanceID + uTime;
    mat4 model = translation(uSpread * sin(vec3(.35, .52, .7) * t)) *
                 rotationY(1.75 * t) * rotationX(1.75 * t) * rotationZ(1.75 * t);
    vColor = .5 * vertPos + .5;
    gl_Position = p_matrix * v_matrix * model * vec4(vertPos, 1.);
}
