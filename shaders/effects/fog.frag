// SH124 Noisy fog: noise changes the depth that decides how much fog there is.
#version 330 core

uniform float uNoiseScale, uNoiseFreq;
uniform float uDepthFront, uDepthBack;   // eye-space z where the fog begins and where it is complete
uniform vec3 uColor, uFogColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-5., 10., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseFreq * vPosition);
    float noise = uNoiseScale * (octaves.r + octaves.g + octaves.b + octaves.a - 2.) * 2.;
    float span = uDepthBack - uDepthFront;
    float depth = abs(span) > 1e-4 ? (vPosition.z + noise - uDepthFront) / span : 0.;
    float fog = smoothstep(0., 1., depth);

    float light = .25 + .75 * max(dot(normalize(vNormal), normalize(kLight - vPosition)), 0.);
    fColor = vec4(mix(light * uColor, uFogColor, fog), 1.);
}
