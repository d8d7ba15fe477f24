// SH092 Octant subdivision: shrinks the eye-space triangles about their centroids and lights their corners.
#version 400 compatibility
#extension GL_EXT_gpu_shader4 : enable
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uShrink;

in vec4 teColor[3];
in vec3 teNormal[3];

out vec4 gColor;

const vec3 kLight = vec3(5., 10., 10.);   // eye space

void main() {
    vec3 centre = (gl_PositionIn[0].xyz + gl_PositionIn[1].xyz + gl_PositionIn[2].xyz) / 3.;
    for (int i = 0; i < 3; ++i) {
        float light = abs(dot(normalize(teNormal[i]), normalize(kLight - gl_PositionIn[i].xyz)));
        gColor = vec4((.15 + .85 * light) * teColor[i].rgb, teColor[i].a);
        gl_Position = gl_ProjectionMatrix * vec4(mix(centre, gl_PositionIn[i].xyz, uShrink), 1.);
        EmitVertex();
    }
    EndPrimitive();
}
