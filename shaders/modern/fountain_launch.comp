// S06 Fountain: at the start the particles are already on their ways, each at a random moment of its flight.
#version 430 core
layout(local_size_x = 64) in;
#include "fountain.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(particles.length())) return;
    vec3 velocity = launchVelocity(i);
    float flight = 2. * velocity.y / uGravity;
    particles[i] = afterFlight(Particle(vec3(0.), velocity), i == 0u ? 0. : flight * randomOf(i, 0u));
}
