// S02 The normal, for light per fragment.
#version 110

varying vec3 vNormal;

void main() {
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
