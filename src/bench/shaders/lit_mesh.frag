// Red is the INTENSITY, green is 1 on the surface; after phong.glsl.
in vec3 vModel;
in vec3 vNormal;
in float vIntensity;
uniform float uRing;
out vec4 fColor;
void main() {
    fColor = vec4(INTENSITY, 1., 0., 1.);
}
