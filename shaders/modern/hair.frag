// G13.4 Hair: the light of a thin cylinder (Kajiya and Kay 1989), dark at the root.
#version 430 core

struct Material {
    vec4 ambient, diffuse, specular;
    float shininess;
};

uniform Material material;
uniform vec3 uLight, cameraPosition;

in vec3 vPlace, vAlong;
in float vHeight;
out vec4 fColor;

void main() {
    vec3 along = normalize(vAlong);
    vec3 toLight = normalize(uLight - vPlace), toEye = normalize(cameraPosition - vPlace);
    float light = dot(along, toLight), eye = dot(along, toEye);
    float diffuse = sqrt(max(1. - light * light, 0.));
    float specular = pow(max(diffuse * sqrt(max(1. - eye * eye, 0.)) - light * eye, 0.), material.shininess);
    vec3 color = material.ambient.rgb + diffuse * material.diffuse.rgb + .6 * specular * material.specular.rgb;
    fColor = vec4(mix(.25, 1.2, vHeight) * color, 1.);
}
