// SH067 SH068 EX11.12 EX11.13 EX11.14 EX11.15 Operations: one colour from the two colours at the same place of two pictures.
#version 330 core

uniform int uOperation;
uniform sampler2D uBaseUnit;
uniform sampler2D uBlendUnit;

in vec2 vST;

out vec4 fColor;

float luminance(vec3 color) {
    return dot(color, vec3(.2125, .7154, .0721));
}

// As light as both pictures in the mean. Black stays black.
vec3 balanced(vec3 color, vec3 a, vec3 b) {
    float now = luminance(color), wanted = .5 * (luminance(a) + luminance(b));
    return now > 0. ? color * wanted / now : color;
}

// Quotients whose divisor is 0 become what they tend to: dark for a burn, light for a dodge.
float burn(float a, float b) {
    return a >= 1. ? 1. : b > 0. ? 1. - min((1. - a) / b, 1.) : 0.;
}

float dodge(float a, float b) {
    return a <= 0. ? 0. : b < 1. ? min(a / (1. - b), 1.) : 1.;
}

void main() {
    vec3 a = texture(uBaseUnit, vST).rgb, b = texture(uBlendUnit, vST).rgb;
    vec3 screened = 1. - (1. - a) * (1. - b);
    vec3 color = a;
    switch (uOperation) {
    case 0: color = a * b; break;
    case 1: color = balanced(a * b, a, b); break;
    case 2: color = min(a, b); break;
    case 3: color = max(a, b); break;
    case 4: color = screened; break;
    case 5: color = balanced(screened, a, b); break;
    case 6: color = abs(a - b); break;
    case 7: color = 1. - abs(1. - a - b); break;
    case 8: color = a + b - 2. * a * b; break;
    case 9: color = vec3(burn(a.r, b.r), burn(a.g, b.g), burn(a.b, b.b)); break;
    case 10: color = vec3(dodge(a.r, b.r), dodge(a.g, b.g), dodge(a.b, b.b)); break;
    default: break;
    }
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
