// S03 Place and normal in eye space.
#version 110

varying vec3 vPlace, vNormal;

void main() {
    vPlace = vec3(gl_ModelViewMatrix * gl_Vertex);
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
