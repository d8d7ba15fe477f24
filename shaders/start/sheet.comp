// Start, the compute shader: element i of the buffer is a point of the sheet; its height is a travelling wave.
#version 430 core
layout(local_size_x = 64) in;

struct Place {
    vec4 point;
};
layout(std430) buffer Places { Place places[]; };

uniform int uSide;
uniform float uHeight, uWaves, uTime;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(places.length())) return;
    vec2 at = (vec2(i % uint(uSide), i / uint(uSide)) + .5) / float(uSide) * 4. - 2.;
    places[i].point = vec4(at.x, uHeight * sin(uWaves * length(at) - 2. * uTime), at.y, 1.);
}
