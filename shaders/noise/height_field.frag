// Height field: valleys and peaks in colours, lit by the normal of each triangle.
#version 330 core

in float vNoise;
in vec3 vPosition;

out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    float light = .3 + .7 * abs(dot(normal, normalize(vec3(-4., 4., 2.))));
    vec3 color = mix(vec3(.15, .35, .45), vec3(.85, .75, .45), smoothstep(-.12, .05, vNoise));
    fColor = vec4(light * mix(color, vec3(1.), smoothstep(.05, .18, vNoise)), 1.);
}
