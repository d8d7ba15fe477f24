// SH072 Break-through: the model position chooses the noise, the texture coordinates the picture.
#version 330 core

out vec3 vModel;
out vec2 vST;

void main() {
    vModel = aVertex.xyz;
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
