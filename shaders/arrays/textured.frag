// V17 A colour, mixed with a texture.
#version 110

uniform sampler2D texHandle;
uniform vec4 vColor;
uniform float weight;

varying vec2 st;

void main() {
    gl_FragColor = mix(vColor, texture2D(texHandle, st), weight);
}
