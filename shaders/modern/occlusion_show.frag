// The mean over the blocks of 4 x 4 turned samples.
#version 430 core

uniform sampler2D uOpen;

out vec4 fColor;

void main() {
    float sum = 0.;
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            ivec2 place = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), textureSize(uOpen, 0) - 1);
            sum += texelFetch(uOpen, place, 0).r;
        }
    fColor = vec4(vec3(sum / 16.), 1.);
}
