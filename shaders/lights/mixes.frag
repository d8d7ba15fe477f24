// G7.f17 Four ways to mix pictures (T) with ambient (A), diffuse (D) and specular (S) light.
#version 410 core

uniform int uMix;
uniform sampler2D uFirst, uSecond;
uniform vec3 uLamps[2], uColors[2];     // places in the world, colours
uniform float uShine, uShare;
uniform vec3 cameraPosition;

in vec3 vPlace, vNormal;
in vec2 vST;
out vec4 fColor;

const float kAmbient = .2;

float diffuse(vec3 toLamp, vec3 normal) {
    return max(dot(normal, toLamp), 0.);
}

float specular(vec3 toLamp, vec3 normal) {
    float cosine = max(dot(reflect(-toLamp, normal), normalize(cameraPosition - vPlace)), 0.);
    return diffuse(toLamp, normal) > 0. ? pow(cosine, uShine) : 0.;
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 first = texture(uFirst, vST).rgb, second = texture(uSecond, vST).rgb;
    vec3 d[2], s[2];
    for (int i = 0; i < 2; ++i) {
        vec3 toLamp = normalize(uLamps[i] - vPlace);
        d[i] = diffuse(toLamp, normal) * uColors[i];
        s[i] = specular(toLamp, normal) * uColors[i];
    }
    vec3 color;
    if (uMix == 0) color = first * (kAmbient + d[0]) + s[0];
    if (uMix == 1) color = first * (kAmbient + d[0] + s[0]);
    if (uMix == 2) color = uShare * first + (1. - uShare) * (kAmbient + d[0] + s[0]);
    if (uMix == 3) color = .25 * (first + second + (kAmbient + d[0] + s[0]) + (kAmbient + d[1] + s[1]));
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
