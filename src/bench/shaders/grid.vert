// A grid of WIDTH x HEIGHT points, in waves.
out vec3 vPosition;
void main() {
    vec2 p = vec2(gl_VertexID % WIDTH, gl_VertexID / WIDTH) / vec2(WIDTH, HEIGHT);
    vPosition = vec3(2. * p - 1., .2 * sin(20. * p.x) * cos(15. * p.y));
    gl_Position = vec4(vPosition.xy * .95, vPosition.z, 1.);
}
