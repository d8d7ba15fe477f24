// R26 The light that comes about each direction: the mean of the probe, weighed by a power of the cosine.
#version 330 core
#include "../common/direction.glsl"

uniform sampler2D uProbeMap;
uniform float uPower;     // 1 diffuse, more for glossy surfaces

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 about = directionAt(vST), sum = vec3(0.);
    float weights = 0.;
    ivec2 size = ivec2(48, 24);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            vec2 st = (vec2(x, y) + .5) / vec2(size);
            float weight = pow(max(dot(directionAt(st), about), 0.), uPower) * sin(kPi * st.t);
            sum += weight * textureLod(uProbeMap, st, 1.).rgb;
            weights += weight;
        }
    fColor = vec4(sum / weights, 1.);
}
