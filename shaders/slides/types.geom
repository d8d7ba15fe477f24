// S16 What comes in, sent out as points, as one closed line, or as a triangle at each vertex. The scene states both types.
#version 150

uniform int uOut;       // 0 points, 1 line_strip, 2 triangle_strip

void corner(vec4 centre, float turns, float size) {
    float angle = 6.2831853 * turns;
    gl_Position = centre + size * vec4(sin(angle), cos(angle), 0., 0.);
    EmitVertex();
}

void main() {
    int count = gl_in.length();
    if (uOut == 1) {
        // A single point becomes a diamond.
        if (count == 1) for (int i = 0; i < 5; ++i) corner(gl_in[0].gl_Position, .25 * float(i), .35);
        else for (int i = 0; i <= count; ++i) {
            gl_Position = gl_in[i % count].gl_Position;
            EmitVertex();
        }
        EndPrimitive();
    }
    else for (int i = 0; i < count; ++i) {
        if (uOut == 0) {
            gl_Position = gl_in[i].gl_Position;
            EmitVertex();
        }
        else for (int k = 0; k < 3; ++k) corner(gl_in[i].gl_Position, float(k) / 3., .16);
        EndPrimitive();
    }
}
