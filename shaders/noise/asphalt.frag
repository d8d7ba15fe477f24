// Asphalt: grains of stone in dark tar; wheels have worn two tracks smooth and pale, and oil drips between them.
#version 330 core

uniform float uWorn, uOil;      // 0 none, 1 much
uniform float uTrack;           // where the wheels run, from the middle
uniform float uGrain;

in vec2 vXY;                    // 0 the middle of the road, y along it
in vec3 vPosition;

out vec4 fColor;

void main() {
    // Two turned lookups: the lattice of the noise is not seen.
    vec4 fine = .7 * (texture(Noise2, uGrain * mat2(.80, .60, -.60, .80) * vXY)
                    + texture(Noise2, 1.37 * uGrain * mat2(.28, .96, -.96, .28) * vXY + .4) - 1.);
    vec4 coarse = texture(Noise2, .11 * uGrain * vXY + .3) - .5;
    float grain = 2. * (fine.r + 1.5 * fine.g + 2. * fine.b);
    vec3 color = vec3(.36, .36, .38) + vec3(.42, .41, .40) * grain + .2 * coarse.r;

    // Two tracks with soft edges, which noise makes irregular.
    float fromTrack = abs(abs(vXY.x) - uTrack) + .25 * coarse.g;
    float worn = uWorn * (1. - smoothstep(.08, .22, fromTrack));
    color = mix(color, vec3(.66, .65, .63) + .1 * grain, .8 * worn);

    // Oil in the middle, in spots.
    float middle = 1. - smoothstep(.10, .28, abs(vXY.x) + .3 * coarse.g);
    float spots = smoothstep(-.10, .12, texture(Noise2, .6 * vXY + .7).r - .5);
    float oil = uOil * middle * spots;
    color = mix(color, vec3(.07, .07, .08), .9 * oil);

    vec2 slope = (1. - .7 * worn) * 2.5 * vec2(fine.g, fine.b);
    vec3 normal = normalize(uNormalMatrix * vec3(slope, 1.));
    vec3 toLight = normalize(vec3(-2., 4., -3.));
    float shine = pow(max(dot(reflect(-toLight, normal), normalize(-vPosition)), 0.), mix(12., 40., oil));
    fColor = vec4(color * (.45 + .55 * max(dot(normal, toLight), 0.)) + (.06 + .25 * oil + .05 * worn) * shine, 1.);
}
