// Round bumps: diffuse light alone, or Phong's three kinds of light, both from the interpolated normal.
#version 330 core

uniform bool uPhong;
uniform vec3 uLight;     // eye space
uniform vec3 uColor;
uniform float uShininess;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(uLight - vPosition), toEye = normalize(-vPosition);
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    vec3 phong = (.15 + .85 * diffuse) * uColor + .7 * specular;
    fColor = vec4(uPhong ? phong : diffuse * uColor, 1.);
}
