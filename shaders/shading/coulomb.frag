// Coulomb: six bands of colour by height, from black below 0 over purple, blue, cyan, green, yellow and red to white.
#version 330 core

uniform float uLow, uHigh;   // the sums at the ends of the colours
uniform float uLit;          // 0 the plain colours, 1 lit

in float vSum;
in vec3 vPosition;

out vec4 fColor;

const vec3 kRamp[6] = vec3[6](vec3(.5, 0., .6), vec3(0., 0., 1.), vec3(0., 1., 1.), vec3(0., 1., 0.), vec3(1., 1., 0.),
                              vec3(1., 0., 0.));

vec3 falseColor(float t) {
    if (t < 0.) return vec3(0.);
    if (t > 1.) return vec3(1.);
    float band = 5. * t;
    int k = min(int(band), 4);
    return mix(kRamp[k], kRamp[k + 1], band - float(k));
}

void main() {
    vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    float light = mix(1., .4 + .6 * abs(dot(normal, normalize(vec3(-3., 4., 3.)))), uLit);
    fColor = vec4(light * falseColor((vSum - uLow) / (uHigh - uLow)), 1.);
}
