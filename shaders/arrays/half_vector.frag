// V05 Modified Phong: the highlight follows the angle between the normal and the vector half way from light to eye.
#version 110

struct Light {
    vec4 ambient, diffuse, specular;
    vec3 position;  // in eye space
};
struct Material {
    vec4 ambient, diffuse, specular;
    float shininess;
};
uniform Light light;
uniform Material material;

varying vec3 place, normal;

void main() {
    vec3 n = normalize(normal), l = normalize(light.position - place), h = normalize(l + normalize(-place));
    vec4 color = light.ambient * material.ambient;
    if (dot(n, l) >= 0.) {
        color += dot(n, l) * light.diffuse * material.diffuse;
        color += pow(max(dot(n, h), 0.), material.shininess) * light.specular * material.specular;
    }
    gl_FragColor = vec4(color.rgb, 1.);
}
