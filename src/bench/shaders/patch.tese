// A surface from the control points of patches. DOMAIN and SPACING are words of the layout; a macro names the surface.
layout(DOMAIN, SPACING, ccw) in;
layout(std140) uniform Points { vec4 uPoints[1024]; };
in float cPatch[];
out vec3 vPosition;
out vec4 vWhere;
int patchNumber;

#ifdef BERNSTEIN
vec4 weights(float t) {
    float s = 1. - t;
    return vec4(s * s * s, 3. * s * s * t, 3. * s * t * t, t * t * t);
}
vec3 surface() {
    vec4 u = weights(gl_TessCoord.x), v = weights(gl_TessCoord.y);
    vec3 sum = vec3(0.);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            sum += u[column] * v[row] * uPoints[patchNumber * 16 + row * 4 + column].xyz;
    return sum;
}
#endif
#ifdef DE_CASTELJAU
vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {
    vec3 ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
    return mix(mix(ab, bc, t), mix(bc, cd, t), t);
}
#endif
#ifdef SYMMETRIC
// A sum of symmetric pairs gives an edge the same bits from both ends (after I. Castano, Water-tight, textured, displaced
// subdivision surface tessellation, NVIDIA, 2008).
vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {
    precise float s = 1. - t;
    precise vec3 ends = s * s * s * a + t * t * t * d;
    precise vec3 middle = s * s * t * b + t * t * s * c;
    precise vec3 sum = ends + 3. * middle;
    return sum;
}
#endif
#if defined DE_CASTELJAU || defined SYMMETRIC
// Four curves along v and one along u.
vec3 surface() {
    vec3 along[4];
    for (int column = 0; column < 4; ++column) {
        int first = patchNumber * 16 + column;
        along[column] = curve(uPoints[first].xyz, uPoints[first + 4].xyz, uPoints[first + 8].xyz,
                              uPoints[first + 12].xyz, gl_TessCoord.y);
    }
    return curve(along[0], along[1], along[2], along[3], gl_TessCoord.x);
}
#endif
#ifdef OCTANT
vec3 surface() { return normalize(gl_TessCoord); }
#endif
#ifdef PN_TRIANGLE
// Three corners and three normals (A. Vlachos et al., Curved PN Triangles, 2001).
vec3 corner(int i) { return uPoints[patchNumber * 6 + i].xyz; }
vec3 normal(int i) { return uPoints[patchNumber * 6 + 3 + i].xyz; }
vec3 near(int i, int j) {
    return (2. * corner(i) + corner(j) - dot(corner(j) - corner(i), normal(i)) * normal(i)) / 3.;
}
vec3 surface() {
    float u = gl_TessCoord.x, v = gl_TessCoord.y, w = gl_TessCoord.z;
    vec3 edges = near(0, 1) + near(1, 0) + near(1, 2) + near(2, 1) + near(2, 0) + near(0, 2);
    vec3 middle = edges / 4. - (corner(0) + corner(1) + corner(2)) / 6.;
    return corner(0) * u * u * u + corner(1) * v * v * v + corner(2) * w * w * w
         + 3. * (near(0, 1) * u * u * v + near(1, 0) * u * v * v + near(1, 2) * v * v * w
               + near(2, 1) * v * w * w + near(2, 0) * w * w * u + near(0, 2) * w * u * u)
         + 6. * middle * u * v * w;
}
#endif

void main() {
    patchNumber = int(cPatch[0]);
    vPosition = surface();
    vWhere = vec4(gl_TessCoord, float(patchNumber));
    gl_Position = vec4(vPosition.xy * .4, vPosition.z * .1, 1.);
}
