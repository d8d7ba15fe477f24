// Docs: the sum of the four octaves of Noise2, spread over black to white.
#version 330 core

in vec2 vST;

out vec4 fColor;

void main() {
    vec4 octaves = texture(Noise2, vST);
    float sum = octaves.r + octaves.g + octaves.b + octaves.a - 2.;
    fColor = vec4(vec3(.5 + 2.2 * sum), 1.);
}
