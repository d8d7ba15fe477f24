// SH033 Pyramid bump map: the light's direction in the frame of bitangent, tangent and normal at the vertex.
#version 330 compatibility

uniform float uLightX, uLightY, uLightZ;   // eye space

attribute vec3 aTangent;   // along growing t

out vec2 vST;
out vec3 vToLight;   // in the frame (along s, along t, outwards)

void main() {
    vST = gl_MultiTexCoord0.st;
    vec3 position = vec3(gl_ModelViewMatrix * gl_Vertex);
    vec3 normal = normalize(gl_NormalMatrix * gl_Normal);
    vec3 tangent = normalize(mat3(gl_ModelViewMatrix) * aTangent);
    vec3 bitangent = cross(tangent, normal);
    vec3 toLight = vec3(uLightX, uLightY, uLightZ) - position;
    vToLight = vec3(dot(toLight, bitangent), dot(toLight, tangent), dot(toLight, normal));
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
