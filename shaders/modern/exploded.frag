// G13.1c Exploded solid: Phong shading in world space, or only the ambient light.
#version 430 core

struct Material {
    vec4 ambient, diffuse, specular;
    float shininess;
};

uniform Material material;
uniform vec3 uLight, cameraPosition;
uniform bool enableLighting;

in Corner {
    vec3 place, normal;
} corner;
out vec4 fColor;

void main() {
    vec3 color = .7 * material.ambient.rgb;
    if (enableLighting) {
        vec3 normal = normalize(corner.normal), toLight = normalize(uLight - corner.place);
        vec3 toEye = normalize(cameraPosition - corner.place);
        color += max(dot(normal, toLight), 0.) * material.diffuse.rgb;
        color += pow(max(dot(reflect(-toLight, normal), toEye), 0.), material.shininess) * material.specular.rgb;
    }
    fColor = vec4(color, 1.);
}
