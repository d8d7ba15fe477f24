// S16 What comes in, sent out as points, as one closed line, or as a triangle at each vertex. The scene states both types.
#version 150

uniform int uOut;       // 0 points, 1 line_strip, 2 triangle_strip

void main() {
    int count = gl_in.length();
    bool isDiamond = uOut == 1 && count == 1;             // a single point as a line
    int ends = uOut == 1 && count > 1 ? count + 1 : count;  // a closed line comes back to its first vertex
    int corners = uOut == 2 ? 3 : isDiamond ? 5 : 1;
    float size = uOut == 2 ? .16 : isDiamond ? .35 : 0.;
    for (int i = 0; i < ends; ++i) {
        // Mesa 25 draws wrong pictures for gl_in[i] where it cannot unroll the loop over i.
        vec4 centre = gl_in[0].gl_Position;
        for (int n = 1; n < count; ++n) if (n == i) centre = gl_in[n].gl_Position;
        for (int k = 0; k < corners; ++k) {
            float angle = 6.2831853 * float(k) / (uOut == 2 ? 3. : 4.);
            gl_Position = centre + size * vec4(sin(angle), cos(angle), 0., 0.);
            EmitVertex();
        }
        if (uOut != 1) EndPrimitive();
    }
}
