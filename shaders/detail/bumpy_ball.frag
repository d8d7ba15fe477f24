// G10.f9 A ball lit by the normals of a map, alone or mixed with a picture.
#version 410 core

uniform sampler2D uNormals, uColors;
uniform float uRepeats, uShare;
uniform vec3 uLight, cameraPosition;

in vec3 vPlace, vNormal, vNorth;
in vec2 vST;
out vec4 fColor;

void main() {
    vec3 up = normalize(vNormal), north = normalize(vNorth - dot(vNorth, up) * up);
    mat3 surface = mat3(cross(north, up), north, up);
    vec2 st = uRepeats * vST * vec2(1., .5);
    vec3 normal = normalize(surface * (2. * texture(uNormals, st).rgb - 1.));
    vec3 toLight = normalize(uLight - vPlace), toEye = normalize(cameraPosition - vPlace);
    float diffuse = max(dot(normal, toLight), 0.) * smoothstep(-.05, .1, dot(up, toLight));
    float specular = diffuse > 0. ? pow(max(dot(normal, normalize(toLight + toEye)), 0.), 40.) : 0.;
    vec3 light = vec3(.06 + .8 * diffuse + .5 * specular);
    fColor = vec4(mix(light, texture(uColors, st).rgb, uShare), 1.);
}
