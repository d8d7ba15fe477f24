// SH075 Shrink: passes the model position on; the geometry stage transforms it.
#version 330 core

out vec4 vColor;
out vec3 vNormal;   // eye space

void main() {
    vColor = aColor;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = aVertex;
}
