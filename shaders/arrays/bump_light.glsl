// Light on a bumpy surface; all vectors are given along tangent, bitangent and normal.

uniform vec3 surfaceColor;
uniform float specularFactor, exponent;

vec3 bumpLight(vec3 n, vec3 l, vec3 v) {
    vec3 color = (.15 + .85 * max(dot(n, l), 0.)) * surfaceColor;
    return color + specularFactor * pow(max(dot(reflect(-l, n), v), 0.), exponent);
}
