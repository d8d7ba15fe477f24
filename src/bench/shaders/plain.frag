// The place on the surface as a colour.
in vec3 vPosition;
out vec4 fColor;
void main() { fColor = vec4(fract(vPosition), 1.); }
