// Two pictures multiplied. Exercise: colour burn and colour dodge.
#version 330 core

uniform int uOperation;     // 9 burn, 10 dodge
uniform sampler2D uBaseUnit;
uniform sampler2D uBlendUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 a = texture(uBaseUnit, vST).rgb, b = texture(uBlendUnit, vST).rgb;
    vec3 color = a * b;
    if (uOperation == 9) color = a;     // Change this to the burn,
    if (uOperation == 10) color = b;    // and this to the dodge.
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
