// Attitudes as quaternions (x, y, z, w) of unit length.

vec4 about(vec3 axis, float angle) {
    return vec4(sin(.5 * angle) * axis, cos(.5 * angle));
}

/// First b, then a.
vec4 product(vec4 a, vec4 b) {
    return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

vec3 turned(vec4 q, vec3 v) {
    return v + 2. * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

/// Yaw about y, pitch about x, roll about z, in radians.
vec4 fromEuler(vec3 angles) {
    vec4 yaw = about(vec3(0., 1., 0.), angles.x), pitch = about(vec3(1., 0., 0.), angles.y);
    return product(yaw, product(pitch, about(vec3(0., 0., 1.), angles.z)));
}

/// Along the shorter arc from a to b, at equal speed.
vec4 slerp(vec4 a, vec4 b, float t) {
    float cosine = dot(a, b);
    if (cosine < 0.) {
        b = -b;
        cosine = -cosine;
    }
    if (cosine > .9995) return normalize(mix(a, b, t));
    float angle = acos(cosine);
    return (sin((1. - t) * angle) * a + sin(t * angle) * b) / sin(angle);
}

/// The part t of the way from no rotation to the one with these angles.
vec4 attitude(vec3 angles, float t, bool bySlerp) {
    return bySlerp ? slerp(vec4(0., 0., 0., 1.), fromEuler(angles), t) : fromEuler(t * angles);
}
