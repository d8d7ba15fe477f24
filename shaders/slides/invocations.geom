// S15 The stage runs twice for each triangle; gl_InvocationID tells the runs apart.
#version 400
layout(triangles, invocations = 2) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uApart;

in vec3 vNormal[];
out vec3 gNormal;
flat out int gCopy;

void main() {
    float side = 2. * float(gl_InvocationID) - 1.;
    for (int i = 0; i < 3; ++i) {
        gNormal = vNormal[i];
        gCopy = gl_InvocationID;
        gl_Position = uProjectionMatrix * (gl_in[i].gl_Position + vec4(side * uApart, 0., 0., 0.));
        EmitVertex();
    }
}
