// S06 Fountain: each vertex is a particle; the colour tells how fast it is.
#version 430 core

struct Particle {
    vec3 place, velocity;
};

layout(std430) readonly buffer Particles { Particle particles[]; };

uniform mat4 mvp_matrix;
uniform float uSpeed;

out vec3 vColor;

void main() {
    Particle p = particles[gl_VertexID];
    float fast = length(p.velocity) / uSpeed;
    vColor = mix(vec3(.02, .06, .20), vec3(.10, .13, .16), fast);
    gl_Position = mvp_matrix * vec4(p.place, 1.);
}
