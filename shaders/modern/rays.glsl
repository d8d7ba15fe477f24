// Rays, and where they meet spheres, boxes and planes.

struct Ray {
    vec3 start, direction;  // the direction has unit length
};
struct Hit {
    float t;          // distance along the ray; kNone if there is none
    vec3 normal;      // away from the object, also if the ray comes from its inside
    bool fromInside;
};

const float kNone = 1e30;
const Hit kNoHit = Hit(kNone, vec3(0.), false);

Hit hitSphere(Ray ray, vec3 center, float radius) {
    vec3 start = ray.start - center;
    float b = dot(start, ray.direction), c = dot(start, start) - radius * radius;
    float d = b * b - c;
    if (d < 0.) return kNoHit;
    float near = -b - sqrt(d), far = -b + sqrt(d);
    float t = near > 0. ? near : far;
    if (t <= 0.) return kNoHit;
    return Hit(t, (start + t * ray.direction) / radius, near <= 0.);
}

/// A box around the origin with these half sides: the ray is inside between the last entry and the first exit of
/// the three pairs of planes (Kay and Kajiya 1986). A zero in the direction gives infinities, which is right.
Hit hitBox(Ray ray, vec3 halfSides) {
    vec3 inverse = 1. / ray.direction;
    vec3 entries = (-sign(ray.direction) * halfSides - ray.start) * inverse;
    vec3 exits = (sign(ray.direction) * halfSides - ray.start) * inverse;
    float near = max(max(entries.x, entries.y), entries.z), far = min(min(exits.x, exits.y), exits.z);
    if (near > far || far <= 0.) return kNoHit;
    float t = near > 0. ? near : far;
    vec3 place = (ray.start + t * ray.direction) / halfSides;
    vec3 size = abs(place);
    vec3 axis = size.y > size.z ? vec3(0., 1., 0.) : vec3(0., 0., 1.);
    if (size.x > max(size.y, size.z)) axis = vec3(1., 0., 0.);
    return Hit(t, axis * sign(place), near <= 0.);
}

/// The same for a box that `placement`, a rotation and a translation, moves.
Hit hitPlacedBox(Ray ray, mat4 placement, vec3 halfSides) {
    mat3 turn = mat3(placement);
    Hit hit = hitBox(Ray(transpose(turn) * (ray.start - placement[3].xyz), transpose(turn) * ray.direction), halfSides);
    hit.normal = turn * hit.normal;
    return hit;
}

/// A level rectangle with these half sides along x and z.
Hit hitTable(Ray ray, vec3 center, vec2 halfSides) {
    if (ray.direction.y == 0.) return kNoHit;
    float t = (center.y - ray.start.y) / ray.direction.y;
    vec3 place = ray.start + t * ray.direction - center;
    if (t <= 0. || any(greaterThan(abs(place.xz), halfSides))) return kNoHit;
    return Hit(t, vec3(0., -sign(ray.direction.y), 0.), false);
}

/// The ray through a pixel for an eye that looks along -z; the picture is two units high at the distance 2.
Ray eyeRay(vec3 eye, ivec2 pixel, ivec2 size) {
    vec2 place = (2. * (vec2(pixel) + .5) - vec2(size)) / float(size.y);
    return Ray(eye, normalize(vec3(place, -2.)));
}
