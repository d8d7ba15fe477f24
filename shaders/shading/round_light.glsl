// Ambient, diffuse and specular light in eye space, the same for vertices and for fragments.
vec3 roundLight(vec3 color, vec3 normal, vec3 position, vec3 light, float shininess) {
    vec3 toEye = normalize(-position);
    vec3 toLight = normalize(light - position);
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), shininess) : 0.;
    return (.15 + .85 * diffuse) * color + .7 * specular;
}
