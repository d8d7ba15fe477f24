// SH032 Ripple bump map: the slopes of two ring waves A cos(2 pi (r/Pd - time)), added, tilt the normal.
#version 330 core

uniform float uAmp0, uAmp1;
uniform float uPd;           // wavelength
uniform float uTime;         // in periods
uniform float uPhaseShift;   // of the second wave, in periods
uniform float uLightX, uLightY, uLightZ;   // model space
uniform vec3 uColor;

in vec2 vXY;
in vec3 vPosition;

out vec4 fColor;

const float kTwoPi = 6.2831853;
const vec2 kCentre0 = vec2(-.65, .25);
const vec2 kCentre1 = vec2(.75, -.20);

// The gradient of the height of a ring wave around `centre`; no angle is needed, only the radial direction.
vec2 slope(vec2 centre, float amplitude, float phase) {
    vec2 outwards = vXY - centre;
    float r = length(outwards);
    if (r == 0.) return vec2(0.);
    return -amplitude * kTwoPi / uPd * sin(kTwoPi * (r / uPd - phase)) * outwards / r;
}

void main() {
    vec2 both = slope(kCentre0, uAmp0, uTime) + slope(kCentre1, uAmp1, uTime + uPhaseShift);
    vec3 normal = normalize(vec3(-both, 1.));
    vec3 toLight = normalize(vec3(uLightX, uLightY, uLightZ) - vec3(vXY, 0.));
    vec3 normalEye = normalize(uNormalMatrix * normal);
    vec3 toLightEye = normalize(mat3(uModelViewMatrix) * toLight);

    float diffuse = max(abs(dot(normal, toLight)), .1);
    float shine = pow(max(dot(reflect(-toLightEye, normalEye), normalize(-vPosition)), 0.), 60.);
    fColor = vec4(diffuse * uColor + .6 * shine, 1.);
}
