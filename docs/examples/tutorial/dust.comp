// Moves each grain on a circle; by Kepler's third law the far ones take longer.
#version 430 core

layout(local_size_x = 64) in;

layout(std430) buffer Dust { vec4 dust[]; };
uniform float dt;   // seconds per step

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(dust.length())) return;
    vec3 p = dust[i].xyz;
    float angle = dt * pow(length(p), -1.5);
    float c = cos(angle), s = sin(angle);
    dust[i].xyz = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}
