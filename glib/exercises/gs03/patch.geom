// Lights the corners of eye-space triangles. Exercise: shrink the triangles.
#version 400
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uLightX, uLightY, uLightZ;   // eye space
uniform mat4 uProjectionMatrix;

in vec4 teColor[3];
in vec3 teNormal[3];

out vec4 gColor;

void main() {
    for (int i = 0; i < 3; ++i) {
        vec3 toLight = normalize(vec3(uLightX, uLightY, uLightZ) - gl_PositionIn[i].xyz);
        float light = .15 + .85 * abs(dot(normalize(teNormal[i]), toLight));
        gColor = vec4(light * teColor[i].rgb, teColor[i].a);
        gl_Position = uProjectionMatrix * vec4(gl_PositionIn[i].xyz, 1.);   // Change this.
        EmitVertex();
    }
    EndPrimitive();
}
