// V15 Particle cloud: each point in its own colour.
#version 110

varying vec3 color;

void main() {
    gl_FragColor = vec4(color, 1.);
}
