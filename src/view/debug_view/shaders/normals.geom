// Normals as lines: the normal of every vertex that the vertex stage leaves where the scene's matrices put it,
// and for every triangle the direction that it faces, from its centre.
layout(triangles) in;
layout(line_strip, max_vertices = 8) out;

uniform mat4 glibra_debugProjection;
uniform mat4 glibra_debugProjectionInverse;
uniform float glibra_debugReach;   // length of a line per unit of clip w

out vec4 glibra_debugColor;

vec3 eyeOf(vec4 clip) {
    vec4 eye = glibra_debugProjectionInverse * clip;
    return eye.xyz / eye.w;
}

void line(vec3 base, float w, vec3 direction, vec4 color) {
    glibra_debugColor = color;
    gl_Position = glibra_debugProjection * vec4(base, 1.);
    EmitVertex();
    glibra_debugColor = color;
    gl_Position = glibra_debugProjection * vec4(base + direction * (glibra_debugReach * w), 1.);
    EmitVertex();
    EndPrimitive();
}

void main() {
    vec3 corners[3];
    for (int i = 0; i < 3; ++i) {
        corners[i] = eyeOf(gl_in[i].gl_Position);
        vec4 normal = glibra_debugNormalOf(i);
        if (normal.w > 0.)
            line(corners[i], abs(gl_in[i].gl_Position.w), normal.xyz, vec4(1., .85, .2, 1.));
    }
    vec3 face = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (dot(face, face) > 0.) {
        vec4 middle = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
        line((corners[0] + corners[1] + corners[2]) / 3., abs(middle.w), normalize(face), vec4(.3, .9, 1., 1.));
    }
}
