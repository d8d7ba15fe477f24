// The six faces of a cube in a cross of 4 x 3 cells: left, front (-z), right and back in the middle row, top above and bottom
// below the front.

/// The direction of a place (0 to 1 in both axes) in a cell, 0 0 being the lower left one; 0 where the cross has no face.
vec3 crossDirection(ivec2 cell, vec2 inside) {
    vec2 p = 2. * inside - 1.;
    if (cell.y == 1) {
        if (cell.x == 0) return vec3(-1., p.y, -p.x);
        if (cell.x == 1) return vec3(p.x, p.y, -1.);
        if (cell.x == 2) return vec3(1., p.y, p.x);
        return vec3(-p.x, p.y, 1.);
    }
    if (cell.x != 1) return vec3(0.);
    return cell.y == 2 ? vec3(p.x, 1., p.y) : vec3(p.x, -1., -p.y);
}
