// S02 Yellow light from the right.
#version 110

varying vec3 vNormal;

const vec3 kColor = vec3(1., 1., 0.);
const vec3 kToLight = vec3(1., 0., 0.);   // eye space

void main() {
    float lit = clamp(dot(normalize(vNormal), kToLight), 0., 1.);
    gl_FragColor = vec4(lit * kColor, 1.);
}
