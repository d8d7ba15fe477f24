// SH001 Sphere: the interpolated light times the colour of the object.
#version 330 core

in vec4 vColor;
in float vLightIntensity;

out vec4 fColor;

void main() {
    fColor = vec4(vLightIntensity * vColor.rgb, vColor.a);
}
