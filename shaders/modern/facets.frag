// G4.4 Facets: one diffuse light in eye space; the derivatives of the place give the normal of the face.
#version 330 compatibility

uniform vec4 uColor;
uniform vec3 uLight;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
    fColor = vec4((.25 + .75 * max(dot(normal, uLight), 0.)) * uColor.rgb, 1.);
}
