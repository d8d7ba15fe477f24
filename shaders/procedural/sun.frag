// R39 Sun: turbulence of a place that time carries through the noise, in colours from dark red over yellow to white.
#version 330 core

uniform float uTime;
uniform float uNoiseScale, uNoiseMag;
uniform vec3 uDark, uLight;

in vec3 vPlace;
in vec3 vNormal;

out vec4 fColor;

float turbulence(vec3 place) {
    vec4 octaves = texture(Noise3, place) - .5;
    return dot(abs(octaves), vec4(1.));
}

void main() {
    // Two layers that move against each other boil.
    vec3 flow = vec3(0., .02, .013) * uTime;
    float boil = turbulence(uNoiseScale * vPlace + flow) + turbulence(1.9 * uNoiseScale * vPlace.zxy - flow) * .6;
    float heat = clamp(1.1 - uNoiseMag * boil, 0., 1.);
    vec3 color = mix(uDark, uLight, heat) + vec3(.5, .5, .5) * smoothstep(.75, 1.1, heat);
    // The rim of the sun is darker than its middle.
    fColor = vec4(color * (.45 + .55 * abs(normalize(vNormal).z)), 1.);
}
