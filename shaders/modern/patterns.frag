// Scales, weave or rings as a height from 0 to 1 with a colour; two subroutine uniforms choose pattern and light.
#version 400 core

uniform float uScale, uTurn;
in vec2 vST;
out vec4 fColor;

// Colour in rgb, height in a.
subroutine vec4 Pattern(vec2 at);
subroutine vec3 Light(vec2 at);
subroutine uniform Pattern uPattern;
subroutine uniform Light uLight;

subroutine(Pattern) vec4 scales(vec2 at) {
    // Of the two rows that reach a place, the lower one lies on top.
    vec4 found = vec4(.16, .32, .35, 0.);
    for (int row = 1; row >= 0; --row) {
        float y = floor(at.y) - float(row);
        float x = floor(at.x + .5*mod(y, 2.)) - .5*mod(y, 2.) + .5;
        vec2 d = (at - vec2(x, y + 1.)) * vec2(1., .62);
        float r = length(d) / .62;
        if (r < 1. && at.y < y + 2.) {
            float edge = smoothstep(1., .85, r);
            found = vec4(mix(vec3(.1, .3, .34), vec3(.35, .72, .62), .5 + .5*d.y/.62) * (.4 + .6*edge), 1. - r*r);
        }
    }
    return found;
}

subroutine(Pattern) vec4 weave(vec2 at) {
    vec2 cell = floor(at);
    vec2 f = fract(at) - .5;
    bool isWarp = mod(cell.x + cell.y, 2.) < 1.;
    float across = isWarp ? f.x : f.y;
    float along = isWarp ? f.y : f.x;
    float height = sqrt(max(0., 1. - 4.*across*across)) * (.55 + .45*cos(3.14159*along));
    vec3 thread = isWarp ? vec3(.72, .24, .18) : vec3(.94, .82, .6);
    return vec4(thread * (.75 + .25*cos(40.*across)), height);
}

subroutine(Pattern) vec4 rings(vec2 at) {
    vec2 d = fract(at / 2.) - .5;
    float wave = .5 + .5*cos(25.*length(d));
    return vec4(mix(vec3(.2, .24, .5), vec3(.95, .75, .3), wave), wave);
}

subroutine(Light) vec3 plain(vec2 at) {
    return uPattern(at).rgb;
}

subroutine(Light) vec3 raised(vec2 at) {
    const float kStep = .02;
    vec4 here = uPattern(at);
    float right = uPattern(at + vec2(kStep, 0.)).a;
    float up = uPattern(at + vec2(0., kStep)).a;
    vec3 normal = normalize(vec3(here.a - right, here.a - up, 6.*kStep));
    vec3 light = normalize(vec3(sin(uTurn), .7, 1.));
    vec3 halfway = normalize(light + vec3(0., 0., 1.));
    return here.rgb*(.25 + .75*max(0., dot(normal, light))) + .35*pow(max(0., dot(normal, halfway)), 40.);
}

void main() {
    fColor = vec4(uLight(uScale * vST), 1.);
}
