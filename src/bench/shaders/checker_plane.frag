// A checkerboard on a plane in perspective.
in vec2 vPlace;
uniform float uSide;
out vec4 fColor;
void main() {
    float distance = 1. / (1.1 - vPlace.y);
    vec2 place = vec2((vPlace.x - .4) * distance, distance) * uSide / 12.;
    ivec2 square = ivec2(floor(place + .377));
    fColor = vec4(float((square.x + square.y) & 1));
}
