// G3.1 Matrices of translation and rotation, written column by column. Angles are in radians; a positive angle turns
// counterclockwise as seen from the tip of the axis.

mat4 translation(vec3 by) {
    return mat4(1., 0., 0., 0.,   0., 1., 0., 0.,   0., 0., 1., 0.,   by, 1.);
}

mat4 rotationX(float angle) {
    float c = cos(angle), s = sin(angle);
    return mat4(1., 0., 0., 0.,   0., c, s, 0.,   0., -s, c, 0.,   0., 0., 0., 1.);
}

mat4 rotationY(float angle) {
    float c = cos(angle), s = sin(angle);
    return mat4(c, 0., -s, 0.,   0., 1., 0., 0.,   s, 0., c, 0.,   0., 0., 0., 1.);
}

mat4 rotationZ(float angle) {
    float c = cos(angle), s = sin(angle);
    return mat4(c, s, 0., 0.,   -s, c, 0., 0.,   0., 0., 1., 0.,   0., 0., 0., 1.);
}
