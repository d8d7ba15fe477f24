// EX12.1 Coloured silhouettes: the edge between a triangle that faces the eye and one that does not, with a colour of its own.
#version 330 core

layout(triangles_adjacency) in;
layout(line_strip, max_vertices = 6) out;

uniform int uBy;   // direction, primitive

out vec3 gColor;

bool facesEye(vec3 a, vec3 b, vec3 c) {
    return dot(cross(b - a, c - a), a) < 0.;
}

vec3 hue(float h) {
    return clamp(abs(fract(h + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
}

vec4 inFront(vec4 position) {   // toward the eye along the line of sight
    return uProjectionMatrix * vec4(.997 * position.xyz, 1.);
}

void main() {
    if (!facesEye(gl_in[0].gl_Position.xyz, gl_in[2].gl_Position.xyz, gl_in[4].gl_Position.xyz)) return;
    for (int i = 0; i < 6; i += 2) {
        int j = (i + 2) % 6;
        // The neighbour traverses the edge in the other direction.
        if (facesEye(gl_in[j].gl_Position.xyz, gl_in[i].gl_Position.xyz, gl_in[i + 1].gl_Position.xyz)) continue;
        vec4 a = inFront(gl_in[i].gl_Position), b = inFront(gl_in[j].gl_Position);
        vec2 along = b.xy / b.w - a.xy / a.w;
        // Both senses of an edge have one colour: half a turn is all hues. A number is spread by the golden ratio.
        float h = uBy == 0 ? (dot(along, along) > 0. ? atan(along.y, along.x) / 3.14159265 : 0.)
                           : float((uint(gl_PrimitiveIDIn) * 2654435769u) >> 8) / 16777216.;
        vec3 color = .25 + .75 * hue(h);
        gColor = color;
        gl_Position = a;
        EmitVertex();
        gColor = color;
        gl_Position = b;
        EmitVertex();
        EndPrimitive();
    }
}
