// SH034 Pyramid bump map: in every cell of the texture square one of four slopes, or the flat ground around them.
#version 330 core

uniform float uBumpDensity;   // number of pyramids along t; along s there are twice as many
uniform float uHeight;
uniform float uAng;           // rotation of the pyramids, degrees
uniform float uAmbient;
uniform vec3 uSurfaceColor;

in vec2 vST;
in vec3 vToLight;

out vec4 fColor;

void main() {
    vec2 inCell = fract(vST * uBumpDensity * vec2(2., 1.)) - .5;
    float angle = radians(-uAng);
    vec2 turned = mat2(cos(angle), sin(angle), -sin(angle), cos(angle)) * inCell;

    vec3 normal = vec3(0., 0., 1.);
    vec2 size = abs(turned);
    if (max(size.x, size.y) < .3) {   // on the pyramid: the slope points along the larger offset
        vec2 slope = size.x > size.y ? vec2(sign(turned.x), 0.) : vec2(0., sign(turned.y));
        vec2 back = mat2(cos(angle), -sin(angle), sin(angle), cos(angle)) * slope;
        normal = normalize(vec3(uHeight * back, 1.));
    }
    vec3 toLight = normalize(vToLight);
    float diffuse = max(dot(normal, toLight), 0.) * smoothstep(-.1, .2, toLight.z);
    fColor = vec4((uAmbient + (1. - uAmbient) * diffuse) * uSurfaceColor, 1.);
}
