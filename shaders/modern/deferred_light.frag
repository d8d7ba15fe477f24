// Deferred shading, second pass: the sum of all lamps at the place that a pixel shows. A lamp fades to nothing at
// its reach.
#version 430 core

struct Lamp {
    vec4 place, color;
};

layout(std430) readonly buffer Lamps { Lamp lamps[]; };
uniform sampler2D places, normals, colors;
uniform vec3 uEye;
uniform float uReach;
uniform int uShow;

in vec2 vST;
out vec4 fColor;

void main() {
    vec4 place = texture(places, vST);
    vec3 normal = texture(normals, vST).xyz, color = texture(colors, vST).rgb;
    vec3 light = .04 * color;
    if (place.w == 0.) light = vec3(0.);
    else
        for (int i = 0; i < lamps.length(); ++i) {
            vec3 toLamp = lamps[i].place.xyz - place.xyz;
            float far = length(toLamp) / uReach;
            if (far >= 1.) continue;
            toLamp = normalize(toLamp);
            float fade = (1. - far * far) * (1. - far * far);
            float specular = pow(max(dot(normal, normalize(toLamp + normalize(uEye - place.xyz))), 0.), 80.);
            light += fade * lamps[i].color.rgb * (max(dot(normal, toLamp), 0.) * color + .5 * specular);
        }
    if (uShow == 1) light = fract(place.xyz);
    if (uShow == 2) light = .5 * normal + .5;
    if (uShow == 3) light = color;
    fColor = vec4(light, 1.);
}
