// S06 Fountain: one step of ballistic motion. With a constant acceleration the step is exact, whatever its length.
#version 430 core
layout(local_size_x = 64) in;
#include "fountain.glsl"

uniform float uStep;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(particles.length())) return;
    Particle p = afterFlight(particles[i], uStep);
    // What has fallen into the basin was launched again at the moment when it met the water.
    if (p.place.y < 0.) p = afterFlight(Particle(vec3(0.), launchVelocity(i)), p.place.y / p.velocity.y);
    particles[i] = p;
}
