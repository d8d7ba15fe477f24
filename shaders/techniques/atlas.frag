// R20 An atlas of eight glyphs in a row, 5 x 7 squares each: G L I B R A * ?
#version 330 core

in vec2 vST;
out vec4 fColor;

// Seven rows of five bits, the lowest row first.
const int kGlyphs[56] = int[56](
    15, 17, 17, 19, 16, 17, 14,    31, 16, 16, 16, 16, 16, 16,    14, 4, 4, 4, 4, 4, 14,    30, 17, 17, 30, 17, 17, 30,
    17, 18, 20, 30, 17, 17, 30,    17, 17, 31, 17, 17, 10, 4,     0, 21, 14, 31, 14, 21, 0, 4, 0, 4, 2, 1, 17, 14);

void main() {
    vec2 place = vST * vec2(8., 1.);
    int glyph = min(int(place.x), 7);
    vec2 square = (vec2(fract(place.x), place.y) - .15) / .7 * vec2(5., 7.);
    bool inside = all(greaterThanEqual(square, vec2(0.))) && all(lessThan(square, vec2(5., 7.)));
    int row = inside ? kGlyphs[7 * glyph + int(square.y)] : 0;
    fColor = vec4(float((row >> (4 - int(square.x))) & 1));
}
