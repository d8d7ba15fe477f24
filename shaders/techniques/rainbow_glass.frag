// R33 Glass that bends blue more than red: three refracted rays, one for each channel.
#version 330 core

uniform samplerCube uSky;
uniform mat4 inverseView;
uniform float uIndex, uDispersion;
uniform float uMirror;

in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

vec3 sky(vec3 direction) { return texture(uSky, mat3(inverseView) * direction).rgb; }

void main() {
    vec3 ray = normalize(vPosition), normal = normalize(vNormal);
    normal = faceforward(normal, ray, normal);
    vec3 index = uIndex + uDispersion * vec3(-1., 0., 1.);
    vec3 through = vec3(sky(refract(ray, normal, 1. / index.r)).r,
                        sky(refract(ray, normal, 1. / index.g)).g,
                        sky(refract(ray, normal, 1. / index.b)).b);
    float root = (1. - uIndex) / (1. + uIndex), f0 = root * root;
    float fresnel = f0 + (1. - f0) * pow(1. - max(dot(normal, -ray), 0.), 5.);
    fColor = vec4(mix(through, sky(reflect(ray, normal)), uMirror * fresnel), 1.);
}
