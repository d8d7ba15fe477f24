// G13.4 Hair: a triangle becomes a line strip that starts at its middle along the normal and bends down toward its tip.
#version 430 core
layout(triangles) in;
layout(line_strip, max_vertices = 13) out;

uniform mat4 v_matrix, p_matrix;
uniform float uLength, uDroop;
uniform int uJoints;

in Corner {
    vec3 place, normal;
} corners[];
out vec3 vPlace, vAlong;
out float vHeight;  // 0 at the root, 1 at the tip

void main() {
    vec3 root = (corners[0].place + corners[1].place + corners[2].place) / 3.;
    vec3 along = normalize(corners[0].normal + corners[1].normal + corners[2].normal);
    vec3 place = root;
    for (int joint = 0; joint <= uJoints; ++joint) {
        vPlace = place;
        vAlong = along;
        vHeight = float(joint) / float(uJoints);
        gl_Position = p_matrix * v_matrix * vec4(place, 1.);
        EmitVertex();
        along = normalize(along - vec3(0., uDroop / float(uJoints), 0.));
        place += uLength / float(uJoints) * along;
    }
    EndPrimitive();
}
