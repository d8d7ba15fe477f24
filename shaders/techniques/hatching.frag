// R53 Woodcut: dark lines as wide as it is dark, and as many per pixel near by as far away.
#version 330 core

uniform float uLines;     // about how many pixels from line to line
uniform float uWander, uInkLight;
uniform vec3 uPaper, uInk;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), toLight = normalize(vec3(-2., 3., 3.) - vPosition);
    float diffuse = max(dot(normal, toLight), 0.);
    float shine = pow(max(dot(reflect(-toLight, normal), normalize(-vPosition)), 0.), 40.);
    float light = clamp(uInkLight + .8 * diffuse + shine, 0., 1.);

    vec4 noise = texture(Noise3, .25 * vModel) - .5;
    float where = vModel.y + .35 * vModel.x + uWander * (noise.r + .5 * noise.g);
    // Lines per unit go up and down in powers of two, so that there are always about as many per pixel.
    float wide = length(vec2(dFdx(where), dFdy(where)));
    float level = -log2(max(uLines * wide, 1e-6)), coarse = floor(level);
    float across = fract(exp2(coarse) * where);
    float saw = abs(2. * across - 1.);                          // 0 in the middle of a line
    // While the level rises, each line splits into the two of the next level.
    float next = abs(2. * saw - 1.);
    float between = mix(saw, next, smoothstep(0., 1., level - coarse));
    float soft = clamp(2. * wide * exp2(level), .05, .5);
    fColor = vec4(mix(uInk, uPaper, smoothstep(-soft, soft, between - (1. - light))), 1.);
}
