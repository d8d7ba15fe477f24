// D01 OvalNoise: texture coordinates for the spots, model position for the noise, eye position for light and depth.
#version 330 core

out vec2 vST;
out vec3 vModel;      // model space
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space
out vec4 vColor;

void main() {
    vST = aTexCoord0.st;
    vModel = aVertex.xyz;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
