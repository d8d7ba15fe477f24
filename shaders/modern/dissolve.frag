// G14.9 Dissolve: what has a noise below the threshold has gone.
#version 430 core

uniform sampler2D uPicture;
uniform sampler3D uNoise;
uniform float uThreshold;

in vec2 vTexCoord;
in vec3 vNoiseCoord;
out vec4 fColor;

void main() {
    if (texture(uNoise, vNoiseCoord).r <= uThreshold) discard;
    fColor = vec4(texture(uPicture, vTexCoord).rgb, 1.);
}
