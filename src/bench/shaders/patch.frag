in vec3 vPosition;
out vec4 fColor;
void main() { fColor = vec4(fract(vPosition.z)); }
