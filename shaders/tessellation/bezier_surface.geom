// SH007 Bezier surface: shrinks the eye-space triangles about their centroids and lights their corners.
#version 400
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uShrink;
uniform float uLightX, uLightY, uLightZ;   // eye space
uniform mat4 uProjectionMatrix;

in vec4 teColor[3];
in vec3 teNormal[3];

out vec4 gColor;

void main() {
    vec3 centre = (gl_PositionIn[0].xyz + gl_PositionIn[1].xyz + gl_PositionIn[2].xyz) / 3.;
    for (int i = 0; i < 3; ++i) {
        vec3 toLight = normalize(vec3(uLightX, uLightY, uLightZ) - gl_PositionIn[i].xyz);
        float light = .15 + .85 * abs(dot(normalize(teNormal[i]), toLight));
        gColor = vec4(light * teColor[i].rgb, teColor[i].a);
        gl_Position = uProjectionMatrix * vec4(mix(centre, gl_PositionIn[i].xyz, uShrink), 1.);
        EmitVertex();
    }
    EndPrimitive();
}
