// Tutorial: hands position, normal, colour and texture coordinates to the fragment stage.
#version 330 core

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space
out vec4 vColor;
out vec2 vST;

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    vColor = aColor;
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
