// R20 Texture bombing: each cell throws glyphs at random places, turned and scaled at random.
#version 330 core

uniform sampler2D uAtlas, uRandom;
uniform float uCells, uTurn, uScale;
uniform int uSamplesPerCell;
uniform vec3 uPaper;

in vec3 vPosition;
in vec3 vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    vec2 place = uCells * vST * vec2(2., 1.);
    ivec2 cell = ivec2(floor(place));
    vec3 color = uPaper;
    float highest = -1.;
    // A glyph may reach into the next cell, so the neighbours throw, too. Of several glyphs the one with the highest number is on top.
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < uSamplesPerCell; ++k) {
            ivec2 from = cell + ivec2(i % 3, i / 3) - 1;
            vec4 a = texelFetch(uRandom, (from + ivec2(7 * k, 13 * k)) & 63, 0);
            vec4 b = texelFetch(uRandom, (from + ivec2(31 + 5 * k, 17)) & 63, 0);
            float angle = uTurn * 6.2832 * (a.z - .5), size = mix(1., .4 + b.x, uScale);
            vec2 p = mat2(cos(angle), -sin(angle), sin(angle), cos(angle)) * (place - vec2(from) - a.xy) / size + .5;
            if (any(lessThan(p, vec2(0.))) || any(greaterThan(p, vec2(1.)))) continue;
            float glyph = floor(7.99 * a.w);
            float ink = textureLod(uAtlas, vec2((glyph + clamp(p.x, .01, .99)) / 8., p.y), 0.).r;
            if (ink < .5 || b.w < highest) continue;
            highest = b.w;
            color = .35 + .45 * cos(6.2832 * (b.y + vec3(0., .33, .67)));
        }
    float light = .35 + .65 * max(dot(normalize(vNormal), normalize(vec3(-1., 1.5, 2.))), 0.);
    fColor = vec4(light * color, 1.);
}
