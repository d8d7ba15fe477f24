// SH001 Sphere: how much light a vertex gets, on either side of the surface.
#version 330 core

// Declared here, as the first shader of a course would do. The program supplies them in any case.
uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;
uniform mat3 uNormalMatrix;

in vec4 aVertex;
in vec3 aNormal;
in vec4 aColor;

out vec4 vColor;
out float vLightIntensity;

const vec3 kLight = vec3(3., 5., 10.);   // eye space

void main() {
    vec4 position = uModelViewMatrix * aVertex;
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vLightIntensity = abs(dot(normalize(kLight - position.xyz), normal));
    vColor = aColor;
    gl_Position = uProjectionMatrix * position;
}
