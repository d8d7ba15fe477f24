// SH073 Break-through: the new picture where the noise is below uT.
#version 330 core

uniform float uT;   // 0 before, 1 after
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec3 vModel;
in vec2 vST;

out vec4 fColor;

// The range of (sum - 1) / 2 of the noise texture. uT is spread over it, so that every value of uT shows a change.
const float kLowest = .36, kHighest = .64;

void main() {
    vec4 octaves = texture(Noise3, vModel / 10.);
    float noise = fract((octaves.r + octaves.g + octaves.b + octaves.a - 1.) / 2.);
    bool after = noise < mix(kLowest, kHighest, uT);
    fColor = vec4(after ? texture(uAfterUnit, vST).rgb : texture(uBeforeUnit, vST).rgb, 1.);
}
