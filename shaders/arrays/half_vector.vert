// V05 Light per fragment: place and normal in eye space.
#version 110

varying vec3 place, normal;

void main() {
    place = vec3(gl_ModelViewMatrix * gl_Vertex);
    normal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
