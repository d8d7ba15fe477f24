// G10.4 Heights from 0 to 1: hills on one side, and a square mesa that is not parallel to the picture's edges.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out float fHeight;

void main() {
    vec2 p = 2. * vST - 1.;
    float hills = .5 + .5 * fractalNoise(vec3(3. * p, 4.2), 5);
    float where = smoothstep(.15, -.35, p.x) * smoothstep(1., .75, abs(p.y)) * smoothstep(-1., -.8, p.x);
    const mat2 kTurned = mat2(.966, .259, -.259, .966);
    vec2 q = abs(kTurned * (p - vec2(.5, .05)));
    float mesa = max(q.x, q.y) < .28 ? .9 : 0.;
    fHeight = clamp(max(.02, max(mesa, 1.1 * where * hills)), 0., 1.);
}
