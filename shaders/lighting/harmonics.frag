// R27 Diffuse light from nine coefficients of spherical harmonics (Ramamoorthi and Hanrahan 2001).
#version 330 core

uniform vec3 uSh[9];      // L00, L1-1, L10, L11, L2-2, L2-1, L20, L21, L22
uniform mat4 inverseView;
uniform vec3 uColor;

in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 n = normalize(mat3(inverseView) * vNormal);
    // The cosine as a filter weighs the bands with pi, 2 pi / 3 and pi / 4; divided by pi, a white surface sends out this.
    vec3 light = .886227 * uSh[0]
        + 2. * .511664 * (uSh[1] * n.y + uSh[2] * n.z + uSh[3] * n.x)
        + 2. * .429043 * (uSh[4] * n.x * n.y + uSh[5] * n.y * n.z + uSh[7] * n.x * n.z)
        + uSh[6] * (.743125 * n.z * n.z - .247708) + .429043 * uSh[8] * (n.x * n.x - n.y * n.y);
    fColor = vec4(uColor * light / 3.14159265, 1.);
}
