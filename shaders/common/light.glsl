// SH010 Ambient, diffuse and specular light of one white point light, everything in eye space; `normal` has unit length.
vec3 adsLight(vec3 color, vec3 normal, vec3 position, vec3 light, float shininess) {
    vec3 toEye = normalize(-position);
    vec3 toLight = normalize(light - position);
    if (dot(normal, toEye) < 0.) normal = -normal;
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), shininess) : 0.;
    return (.2 + .8 * diffuse) * color + .6 * specular;
}
