// SH075 Shrink: model space is left to the geometry stage.
#version 330 core

out vec4 vColor;
out vec3 vNormal;   // eye space

void main() {
    vColor = aColor;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = aVertex;
}
