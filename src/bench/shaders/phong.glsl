// Ambient + diffuse + highlight by the reflection (B. T. Phong, Illumination for Computer Generated Pictures, 1975).
uniform vec3 uLight;
uniform float uExponent;
uniform mat3 uToEye;
float intensity(vec3 n) {
    float facing = dot(n, uLight);
    float shine = facing > 0. ? pow(max(reflect(-uLight, n).z, 0.), uExponent) : 0.;
    return .1 + .5 * max(facing, 0.) + .4 * shine;
}
