// SH089 PN triangles: scaled corners and their normals, in eye space.
#version 400 compatibility

uniform float uScale;

out vec3 vNormal;
out vec4 vColor;

void main() {
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vColor = gl_Color;
    gl_Position = gl_ModelViewMatrix * vec4(uScale * gl_Vertex.xyz, 1.);
}
