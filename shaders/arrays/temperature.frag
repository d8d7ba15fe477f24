// V07 A colour between cold and hot.
#version 110

uniform vec3 coldColor, hotColor;

varying float temperature;

void main() {
    gl_FragColor = vec4(mix(coldColor, hotColor, temperature), 1.);
}
