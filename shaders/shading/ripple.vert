// SH002 Ripple: the height of a vertex follows from its distance to the centre, and its normal from the two slopes.
#version 330 core

uniform mat4 uModelViewMatrix;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;

in vec4 aVertex;
in vec4 aColor;

out vec4 vColor;
out float vLightIntensity;

const float kHeight = .3;
const vec3 kLight = vec3(0., 10., 0.);   // eye space

void main() {
    float r2 = dot(aVertex.xy, aVertex.xy);
    vec4 raised = vec4(aVertex.xy, kHeight * sin(r2), 1.);

    vec2 slope = 2. * kHeight * cos(r2) * aVertex.xy;
    vec3 normal = normalize(uNormalMatrix * cross(vec3(1., 0., slope.x), vec3(0., 1., slope.y)));

    vec3 toLight = normalize(kLight - vec3(uModelViewMatrix * raised));
    vLightIntensity = clamp(.3 + abs(dot(normal, toLight)), 0., 1.);
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * raised;
}
