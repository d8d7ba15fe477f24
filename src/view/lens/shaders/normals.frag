// The colour of a normal's line.
in vec4 glibra_lensColor;
layout(location = 0) out vec4 glibra_lensOut;

void main() {
    glibra_lensOut = glibra_lensColor;
}
