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
    bool isDiamond = uOut == 1 && count == 1;
    for (int i = 0; i < count; ++i) {
        vec4 place = gl_in[i].gl_Position;
        if (uOut == 2) for (int k = 0; k < 3; ++k) corner(place, float(k) / 3., .16);
        else if (isDiamond) for (int k = 0; k < 5; ++k) corner(place, .25 * float(k), .35);
        else corner(place, 0., 0.);
        if (uOut != 1) EndPrimitive();
    }
    // A closed line comes back to its first vertex.
    if (uOut == 1 && count > 1) corner(gl_in[0].gl_Position, 0., 0.);
}
