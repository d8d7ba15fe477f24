// A mesh without perspective, lit at its vertices; after phong.glsl.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
uniform float uScale;
out vec3 vModel;
out vec3 vNormal;
out float vIntensity;
void main() {
    vModel = aPosition;
    vNormal = uToEye * aNormal;
    vIntensity = intensity(vNormal);
    vec3 eye = uToEye * aPosition;
    gl_Position = vec4(eye.xy * uScale, -.5 * eye.z, 1.);
}
