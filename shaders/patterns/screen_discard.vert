// SH003 Screen discard: light at every vertex, texture coordinates for the mesh.
#version 330 core

uniform mat4 uModelViewMatrix;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;

in vec4 aVertex;
in vec3 aNormal;
in vec4 aColor;
in vec4 aTexCoord0;

out vec4 vColor;
out vec2 vST;

const vec3 kLight = vec3(0., 0., 10.);   // eye space

void main() {
    vec3 position = vec3(uModelViewMatrix * aVertex);
    vec3 normal = normalize(uNormalMatrix * aNormal);
    float light = clamp(.3 + abs(dot(normal, normalize(kLight - position))), 0., 1.);
    vColor = vec4(light * aColor.rgb, aColor.a);
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
