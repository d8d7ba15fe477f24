// S06 Particles and how they are launched: number 0 straight up, the others at random within a cone.

struct Particle {
    vec3 place, velocity;
};

uniform float uSpeed, uSpread, uGravity;

/// Where a particle is after `seconds` of free flight.
Particle afterFlight(Particle p, float seconds) {
    p.place += seconds * p.velocity - vec3(0., .5 * uGravity * seconds * seconds, 0.);
    p.velocity.y -= uGravity * seconds;
    return p;
}

layout(std430) buffer Particles { Particle particles[]; };

uint mixBits(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
float randomOf(uint i, uint which) {
    return float(mixBits(mixBits(i) + which) >> 8) / 16777216.;
}

vec3 launchVelocity(uint i) {
    if (i == 0u) return vec3(0., uSpeed, 0.);
    float angle = 6.2831853 * randomOf(i, 1u), lean = uSpread * sqrt(randomOf(i, 2u));
    float speed = uSpeed * mix(.85, 1., randomOf(i, 3u));
    return speed * vec3(sin(lean) * cos(angle), cos(lean), sin(lean) * sin(angle));
}
