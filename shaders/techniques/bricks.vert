// R01 Light per vertex, and the model's own x, y and z, in which the bricks are laid.
#version 140

uniform mat4 MVMatrix, MVPMatrix;
uniform mat3 NormalMatrix;
uniform vec3 LightPosition;   // eye space
uniform float PatternScale;

in vec4 MCvertex;
in vec3 MCnormal;

out float vLight;
out vec3 vPlace;

const float kSpecular = .3;
const float kDiffuse = 1. - kSpecular;

void main() {
    vec3 place = vec3(MVMatrix * MCvertex);
    vec3 normal = normalize(NormalMatrix * MCnormal);
    vec3 toLight = normalize(LightPosition - place);
    float diffuse = max(dot(toLight, normal), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), normalize(-place)), 0.), 16.) : 0.;
    vLight = kDiffuse * diffuse + kSpecular * specular;
    vPlace = PatternScale * MCvertex.xyz;
    gl_Position = MVPMatrix * MCvertex;
}
