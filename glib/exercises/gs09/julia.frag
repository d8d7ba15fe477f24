// The Mandelbrot set on a model. Exercise: a Julia set.
#version 330 core

uniform int uMaxIters;
uniform float uSize;   // of the window, per model unit
uniform vec3 uColor1, uColor2;

in vec2 vXY;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec2 z = vec2(0.);
    vec2 c = vXY * uSize;
    int iterations = 0;
    while (iterations < uMaxIters && dot(z, z) < 64.) {
        z = vec2(z.x * z.x - z.y * z.y, 2. * z.x * z.y) + c;
        ++iterations;
    }
    float smoothed = float(iterations) - (iterations < uMaxIters ? log2(log(length(z)) / log(8.)) : 0.);
    vec3 color = mix(uColor1, uColor2, clamp(sqrt(max(smoothed, 0.) / 60.), 0., 1.));

    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(kLight - vPosition);
    float shine = .35 * pow(max(dot(reflect(-toLight, normal), normalize(-vPosition)), 0.), 50.);
    fColor = vec4((.35 + .65 * abs(dot(normal, toLight))) * color + shine, 1.);
}
