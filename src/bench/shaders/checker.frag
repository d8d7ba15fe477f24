// A checkerboard of .83 x .61 pixels per square.
in vec2 vPlace;
uniform float uSide;
out vec4 fColor;
void main() {
    ivec2 square = ivec2(floor(vPlace * uSide / vec2(.83, .61) + .377));
    fColor = vec4(float((square.x + square.y) & 1));
}
