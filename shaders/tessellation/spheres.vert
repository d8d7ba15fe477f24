// SH084 Spheres: a vertex is a centre and, in w, a radius.
#version 400 compatibility

out vec3 vCentre;
out float vRadius;
out vec4 vColor;

void main() {
    vCentre = gl_Vertex.xyz;
    vRadius = gl_Vertex.w;
    vColor = gl_Color;
    gl_Position = vec4(gl_Vertex.xyz, 1.);
}
