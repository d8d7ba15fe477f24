// V18 The light on a sphere, mixed with a texture.
#version 110

uniform sampler2D texHandle;
uniform float weight;
uniform vec3 eyeInModel, lightPosition;
uniform vec3 ambient, diffuse, specular;
uniform float shininess;

varying vec2 st;
varying vec3 place;

void main() {
    vec3 n = normalize(place), l = normalize(lightPosition - place), v = normalize(eyeInModel - place);
    vec3 intensity = ambient + max(dot(n, l), 0.) * diffuse;
    if (dot(n, l) > 0.) intensity += pow(max(dot(2. * dot(n, l) * n - l, v), 0.), shininess) * specular;
    gl_FragColor = vec4(mix(intensity, texture2D(texHandle, st).rgb, weight), 1.);
}
