// V12 Lit sphere: ambient, diffuse and specular light with r = 2 (n.l) n - l.
#version 110

uniform vec3 eyeInModel, lightPosition;
uniform vec3 ambient, diffuse, specular;
uniform float shininess;

varying vec3 place;

void main() {
    vec3 n = normalize(place), l = normalize(lightPosition - place), v = normalize(eyeInModel - place);
    vec3 r = 2. * dot(n, l) * n - l;
    vec3 color = ambient + max(dot(n, l), 0.) * diffuse;
    if (dot(n, l) > 0.) color += pow(max(dot(r, v), 0.), shininess) * specular;
    gl_FragColor = vec4(color, 1.);
}
