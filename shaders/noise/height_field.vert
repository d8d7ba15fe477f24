// Height field: a square raised by 2D noise that the vertex stage reads from its texture.
#version 330 core

uniform int uOctaves;        // 1 to 4
uniform float uHeight;
uniform float uNoiseScale;

out float vNoise;     // about -.5 to .5
out vec3 vPosition;   // eye space

float noiseAt(vec2 place) {
    vec4 octaves = textureLod(Noise2, uNoiseScale * place, 0.) - .5;
    float sum = 0.;
    for (int i = 0; i < uOctaves; ++i) sum += octaves[i];
    return sum;
}

void main() {
    vNoise = noiseAt(aVertex.xy);
    vec4 raised = vec4(aVertex.xy, uHeight * vNoise, 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
