// D16 Painting: every place takes the lightest colour under a brush of 5 x 5 texels.
#version 330 core

uniform int uBrush[25];     // 1 where the brush has hairs
uniform float uScale;       // texels per hair
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 step = uScale / vec2(textureSize(uImageUnit, 0));
    vec3 lightest = vec3(0.);
    float most = -1.;
    for (int k = 0; k < 25; k++) {
        if (uBrush[k] == 0) continue;
        vec3 color = textureLod(uImageUnit, vST + step * vec2(k % 5 - 2, k / 5 - 2), 0.).rgb;
        float light = dot(color, vec3(.2125, .7154, .0721));
        if (light > most) {
            most = light;
            lightest = color;
        }
    }
    fColor = vec4(lightest, 1.);
}
