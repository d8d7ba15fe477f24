// The colour of a normal's line.
in vec4 glibra_debugColor;
layout(location = 0) out vec4 glibra_debugOut;

void main() {
    glibra_debugOut = glibra_debugColor;
}
