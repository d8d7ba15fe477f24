// S10 Gooch: cool to warm by t = (N.L + 1) / 2. In the second pass alpha is 0, and the lines of the back faces are black.
#version 110

uniform vec3 uLightPlace;       // eye space
uniform vec3 uSurface, uWarm, uCool;
uniform float uWarmShare, uCoolShare, uAlpha;

varying vec3 vPlace, vNormal;

void main() {
    vec3 normal = normalize(vNormal), toLight = normalize(uLightPlace - vPlace);
    vec3 cool = min(uCool + uCoolShare * uSurface, 1.), warm = min(uWarm + uWarmShare * uSurface, 1.);
    float t = .5 * (dot(normal, toLight) + 1.);
    float shine = pow(max(dot(reflect(-toLight, normal), normalize(-vPlace)), 0.), 32.);
    gl_FragColor = vec4(min(mix(cool, warm, t) + shine, 1.) * uAlpha, 1.);
}
