// S20 A colour for each line.
#version 400

in float vLine;
out vec4 fColor;

void main() { fColor = vec4(.6 + .4 * cos(6.2831853 * (.8 * vLine + vec3(0., .33, .67))), 1.); }
