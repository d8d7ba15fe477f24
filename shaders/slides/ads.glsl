// S03 Ambient, diffuse and specular light of a point light, with the half vector; the sum is clamped.
uniform vec3 uLightPlace;       // eye space
uniform vec3 uAmbient, uDiffuse, uSpecular;
uniform float uShininess;

vec4 adsLight(vec3 place, vec3 normal) {
    vec3 toEye = normalize(-place), toLight = normalize(uLightPlace - place);
    if (dot(normal, toEye) < 0.) normal = -normal;
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(normal, normalize(toLight + toEye)), 0.), uShininess) : 0.;
    return vec4(clamp(uAmbient + diffuse * uDiffuse + specular * uSpecular, 0., 1.), 1.);
}
