// SH075 Shrink: V' = C + uShrink (V - C), where C is the centroid.
#version 330
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uShrink;
uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;

in vec4 vColor[3];
in vec3 vNormal[3];

out vec3 gColor;

const vec3 kLight = vec3(0., 10., 4.);   // eye space

void main() {
    vec3 centre = (gl_PositionIn[0].xyz + gl_PositionIn[1].xyz + gl_PositionIn[2].xyz) / 3.;
    for (int i = 0; i < 3; ++i) {
        vec4 position = uModelViewMatrix * vec4(mix(centre, gl_PositionIn[i].xyz, uShrink), 1.);
        float light = .25 + .75 * abs(dot(normalize(vNormal[i]), normalize(kLight - position.xyz)));
        gColor = light * vColor[i].rgb;
        gl_Position = uProjectionMatrix * position;
        EmitVertex();
    }
    EndPrimitive();
}
