// Moves the points of the cloth by their inertia, gravity and wind (Verlet 1967). Two corners are pinned.
#version 430 core

layout(local_size_x = 64) in;

layout(std430) buffer Cloth { vec4 points[]; };
layout(std430) buffer Before { vec4 before[]; };
uniform float uWind, dt;
uniform int uSide;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(points.length()) || i == 0u || i == uint(uSide) - 1u) return;
    vec4 now = points[i];
    vec3 force = vec3(uWind, -9.8, .4 * uWind);
    points[i].xyz = now.xyz + .995 * (now.xyz - before[i].xyz) + dt * dt * force;
    before[i] = now;
}
