// Start, the table: one colour that fades away with distance, and a soft round shadow below the pot.
#version 330 core

uniform vec3 uTableColor;
uniform float uShadow;   // 0 none, 1 black

in vec2 vPlace;

out vec4 fColor;

void main() {
    vec2 fromShadow = (vPlace - vec2(.12, -.10)) / vec2(1.25, .95);
    float shade = uShadow * (1. - smoothstep(.35, 1.35, length(fromShadow)));
    float fade = 1. - smoothstep(1.5, 5.5, length(vPlace));
    fColor = vec4(uTableColor * (1. - shade), fade);
}
