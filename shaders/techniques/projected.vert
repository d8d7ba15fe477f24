// R65 The place in the slide of a projector, besides what light needs.
#version 330 core

uniform mat4 uProjector;

out vec4 vSlide;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vSlide = uProjector * aVertex;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
