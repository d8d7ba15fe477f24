// The light, the material and the sum of ambient, diffuse and specular light (Phong 1975) in world space.

struct Light {
    vec4 ambient, diffuse, specular;
    vec3 position;
};
struct Material {
    vec4 ambient, diffuse, specular;
    float shininess;
};

uniform vec4 globalAmbient;
uniform Light light;
uniform Material material;

vec3 ambientLight() {
    return (globalAmbient + light.ambient).rgb * material.ambient.rgb;
}

/// `normal`, `toLight` and `toEye` have unit length.
vec3 diffuseLight(vec3 normal, vec3 toLight) {
    return max(dot(normal, toLight), 0.) * light.diffuse.rgb * material.diffuse.rgb;
}

vec3 specularLight(vec3 normal, vec3 toLight, vec3 toEye) {
    float cosine = max(dot(reflect(-toLight, normal), toEye), 0.);
    return pow(cosine, material.shininess) * light.specular.rgb * material.specular.rgb;
}

/// Blinn 1977: the half vector in place of the reflected one. Its angle is about half as large, so the exponent
/// is three times that of the material.
vec3 blinnLight(vec3 normal, vec3 toLight, vec3 toEye) {
    float cosine = max(dot(normal, normalize(toLight + toEye)), 0.);
    return pow(cosine, 3. * material.shininess) * light.specular.rgb * material.specular.rgb;
}
