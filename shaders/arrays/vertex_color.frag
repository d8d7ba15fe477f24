// V01 V02 The colours of the corners, interpolated.
#version 330

in vec3 vColor;
out vec4 fColor;

void main() {
    fColor = vec4(vColor, 1.);
}
