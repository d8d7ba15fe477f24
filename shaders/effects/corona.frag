// EX16.6 Corona: light of wavelength lambda, bent by droplets of diameter d, has the brightness (2 J1(x) / x)^2 at the angle
// theta, x = pi d sin(theta) / lambda. Nine wavelengths make the colours.
#version 330 core

#include "../common/rainbow.glsl"

uniform float uDiameter;   // of the droplets, micrometres
uniform float uView;       // from the middle of the picture to its edge, degrees
uniform float uStrength;
uniform float uCloud;

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

// The Bessel function J1, to 1e-3 (Abramowitz and Stegun 9.4.4 shortened, 9.4.6 at its first order).
float besselJ1(float x) {
    if (x < 3.) {
        float y = x * x / 9.;
        return x * (.5 + y * (-.56249985 + y * (.21093573 + y * (-.03954289 + y * (.00443319 - .00031761 * y)))));
    }
    float y = 3. / x;
    float size = .79788456 + y * (.00000156 + y * (.01659667 + .00017105 * y));
    float phase = x - 2.35619449 + y * (.12499612 + y * (.0000565 - .00637879 * y));
    return size * cos(phase) / sqrt(x);
}

void main() {
    float radius = length(vXY);
    float theta = radians(uView * radius);
    vec3 sum = vec3(0.), all = vec3(0.);
    for (int i = 0; i < 9; ++i) {
        float share = (float(i) + .5) / 9.;
        float lambda = mix(.41, .68, share);
        float x = max(3.14159265 * uDiameter * sin(theta) / lambda, 1e-3);
        float bright = 2. * besselJ1(x) / x;
        vec3 color = rainbow(share);
        sum += bright * bright * color;
        all += color;
    }
    vec3 glow = pow(sum / all, vec3(.4));   // a film shows ratios: the power makes the faint rings visible

    float mean = dot(glow, vec3(1. / 3.));
    glow = max(mix(vec3(mean), glow, 1.9), 0.);   // deeper colours than in the sky

    vec4 octaves = texture(Noise3, vec3(.55 * vST + .1, .4));
    float cloud = mix(1., clamp(.62 + 1.1 * (octaves.r + octaves.g + octaves.b + octaves.a - 2.), .15, 1.), uCloud);
    vec3 sky = mix(vec3(.02, .03, .06), vec3(.10, .11, .14), cloud);
    vec3 color = sky + uStrength * cloud * .8 * glow * vec3(1., .97, .9);
    // The moon is half a degree wide.
    color = mix(vec3(1., 1., .93), color, smoothstep(.9, 1.1, uView * radius / .26));
    fColor = vec4(min(color, 1.), 1.);
}
