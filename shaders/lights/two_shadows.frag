// G8.n Two shadows: each light counts where its own map lets it through. A texture, if any, gives the colour.
#version 410 core

uniform sampler2DShadow uLampMap, uSunMap;
uniform sampler2D uImage;
uniform vec3 uLamp, uSun;           // place of the lamp, direction to the sun
uniform vec3 uLampColor, uSunColor, uColor;
uniform bool uTextured;

in vec3 vPlace, vNormal;
in vec2 vST;
in vec4 vLamp, vSun;
out vec4 fColor;

float lit(sampler2DShadow map, vec4 place) {
    float sum = 0., texel = 1. / float(textureSize(map, 0).x);
    for (int i = 0; i < 9; ++i) {
        vec2 offset = 1.2 * texel * (vec2(i % 3, i / 3) - 1.);
        sum += textureProj(map, place + vec4(offset * place.w, 0., 0.));
    }
    return sum / 9.;
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 light = vec3(.2);
    light += lit(uLampMap, vLamp) * max(dot(normal, normalize(uLamp - vPlace)), 0.) * uLampColor;
    light += lit(uSunMap, vSun) * max(dot(normal, normalize(uSun)), 0.) * uSunColor;
    vec3 color = uTextured ? texture(uImage, vST).rgb : uColor;
    fColor = vec4(light * color, 1.);
}
