// Spheres of octants (OCTANTS), or of one rectangle of longitude and latitude each; after octants.glsl. AT_ORIGIN leaves
// them at the origin with radius 1, for captures.
#ifdef OCTANTS
layout(triangles, equal_spacing, ccw) in;
#else
layout(quads, equal_spacing, ccw) in;
#endif
in int cNumber[];
out vec3 vPosition;
void main() {
#ifdef OCTANTS
    int ball = cNumber[0] / 8;
    vec3 p = octantSigns(cNumber[0] % 8) * normalize(gl_TessCoord);
#else
    int ball = cNumber[0];
    float around = 6.283185307 * gl_TessCoord.x, up = 3.14159265 * (gl_TessCoord.y - .5);
    vec3 p = vec3(cos(up) * cos(around), sin(up), cos(up) * sin(around));
#endif
#ifdef AT_ORIGIN
    vPosition = p;
    gl_Position = vec4(.5 * p, 1.);
#else
    vPosition = placed(p, ball);
    gl_Position = vec4(vPosition, 1.);
#endif
}
