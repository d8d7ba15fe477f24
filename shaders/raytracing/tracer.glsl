// A ray tracer for a list of objects that the scene gives: rooms, balls, boxes and planes, which have a colour or a pattern,
// mirror, and let light through. A ray carries a weight, the product of what it met before; so the picture is the sum over all
// rays, and a stack holds the rays that still have to be followed.
//
// Before the #include: `#define SHADOWS` for shadows, `#define SKY` for a sky of six pictures where no object is,
// `#define MARBLE` for that pattern, `#define FIRST_HIT` if nothing mirrors or lets light through: a software driver compiles
// each of them for half a second.
#include "modern/rays.glsl"
#include "modern/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

struct Object {
    int kind;
    vec3 center, turn, size;  // turn: degrees about x, then y, then z; size: half sides, or the radius
    vec3 color;
    int pattern;
    float own, mirror, glass;  // shares of its own lit colour, of what it mirrors, and of what shines through
    float index;               // index of refraction
};
const int kRoom = 0, kBall = 1, kBox = 2, kPlane = 3;
const int kPlain = 0, kChecker = 1, kMarble = 2;

layout(std430) readonly buffer Objects {
    Object objects[];
};
layout(rgba8) uniform writeonly image2D uPicture;
uniform vec3 uEye, uLight;
uniform vec3 uBackground = vec3(0.);
uniform ivec2 uPanels = ivec2(1);    // the picture consists of so many, each with a depth of its own
uniform int uDepths[4] = int[4](4, 4, 4, 4);  // how many surfaces a ray may meet after the first one
uniform float uOffset = .001;        // how far a new ray starts from the surface

struct Pending {
    Ray ray;
    vec3 weight;
    int depth;
};
Pending stack[20];

mat3 turned(vec3 degrees) {
    vec3 c = cos(radians(degrees)), s = sin(radians(degrees));
    mat3 x = mat3(1., 0., 0., 0., c.x, s.x, 0., -s.x, c.x);
    mat3 y = mat3(c.y, 0., -s.y, 0., 1., 0., s.y, 0., c.y);
    mat3 z = mat3(c.z, s.z, 0., -s.z, c.z, 0., 0., 0., 1.);
    return z * y * x;
}

Hit hitObject(Ray ray, Object object) {
    if (object.kind == kBall) return hitSphere(ray, object.center, object.size.x);
    // Boxes and planes are met in their own space.
    mat3 turn = object.turn == vec3(0.) ? mat3(1.) : turned(object.turn);
    Ray own = Ray((ray.start - object.center) * turn, ray.direction * turn);
    Hit hit = object.kind == kPlane ? hitTable(own, vec3(0.), object.size.xz) : hitBox(own, object.size);
    hit.normal = turn * hit.normal;
    // The eye is inside of the room: its normals point inward.
    if (object.kind == kRoom) hit.normal = -hit.normal, hit.fromInside = false;
    return hit;
}

Hit nearest(Ray ray, out int which) {
    Hit best = kNoHit;
    which = 0;
    for (int i = 0; i < objects.length(); ++i) {
        Hit hit = hitObject(ray, objects[i]);
        if (hit.t < best.t) best = hit, which = i;
    }
    return best;
}

/// How much light reaches a place: glass lets a part of it through.
float lightAt(vec3 place, vec3 toLight) {
    float light = 1.;
#ifdef SHADOWS
    for (int i = 0; i < objects.length(); ++i)
        if (objects[i].kind != kRoom && hitObject(Ray(place, toLight), objects[i]).t < distance(place, uLight))
            light *= .8 * min(objects[i].glass, 1.);
#endif
    return light;
}

vec3 surfaceColor(Object object, vec3 place) {
    vec3 p = place - object.center;
    if (object.turn != vec3(0.)) p = p * turned(object.turn);
    if (object.pattern == kChecker) {
        // 24 tiles along the longer side; the small shift keeps faces off the borders of tiles.
        ivec3 tile = ivec3(floor(p * 12. / max(object.size.x, object.size.z) + 1e-3));
        return ((tile.x + tile.y + tile.z) & 1) == 0 ? vec3(.08) : object.color;
    }
#ifdef MARBLE
    if (object.pattern == kMarble) {
        float vein = abs(sin(4. * (p.x + p.y + p.z) + 4. * fractalNoise(1.5 * p, 4)));
        return mix(vec3(.20, .24, .34), object.color, pow(vein, .6));
    }
#endif
    return object.color;
}

#ifdef SKY
uniform sampler2D uRight, uLeft, uTop, uBottom, uBack, uFront;  // +x -x +y -y +z -z

/// The longest component of the direction chooses the picture; the other two are the place in it.
vec3 skyColor(vec3 d) {
    vec3 size = abs(d);
    if (size.x >= max(size.y, size.z))
        return d.x > 0. ? textureLod(uRight, vec2(-d.z, d.y) / size.x * .5 + .5, 0.).rgb
                        : textureLod(uLeft, vec2(d.z, d.y) / size.x * .5 + .5, 0.).rgb;
    if (size.y >= size.z)
        return d.y > 0. ? textureLod(uTop, vec2(d.x, -d.z) / size.y * .5 + .5, 0.).rgb
                        : textureLod(uBottom, vec2(d.x, d.z) / size.y * .5 + .5, 0.).rgb;
    return d.z > 0. ? textureLod(uBack, d.xy / size.z * .5 + .5, 0.).rgb
                    : textureLod(uFront, vec2(-d.x, d.y) / size.z * .5 + .5, 0.).rgb;
}
#else
vec3 skyColor(vec3 d) {
    return uBackground;
}
#endif

vec3 trace(Ray first, int maxDepth) {
    vec3 color = vec3(0.);
    Pending now = Pending(first, vec3(1.), 0);
    int height = 0;
    bool more = true;
    while (more) {
        bool mirrors = false;  // whether the mirrored ray is the next one
        int which;
        Hit hit = nearest(now.ray, which);
        if (hit.t == kNone) color += now.weight * skyColor(now.ray.direction);
        else {
            Object object = objects[which];
            vec3 place = now.ray.start + hit.t * now.ray.direction;
            vec3 normal = hit.fromInside ? -hit.normal : hit.normal;  // toward the ray
            vec3 paint = surfaceColor(object, place);

            // Ambient and diffuse light, and a highlight unless the surface is dull.
            vec3 toLight = normalize(uLight - place);
            float light = hit.fromInside ? 0. : lightAt(place + uOffset * normal, toLight);
            if (!hit.fromInside)
                color += now.weight * object.own * (.3 + .7 * light * max(dot(normal, toLight), 0.)) * paint;
            if (!hit.fromInside && object.kind != kRoom && object.kind != kPlane && dot(normal, toLight) > 0.)
                color += now.weight * .6 * light * pow(max(dot(reflect(-toLight, normal), -now.ray.direction), 0.), 60.);

#ifndef FIRST_HIT
            if (now.depth < maxDepth) {
                // Inside of glass, light only leaves it, or is mirrored if it cannot.
                float mirrored = hit.fromInside ? 0. : object.mirror;
                if (object.glass > 0.) {
                    vec3 direction = refract(now.ray.direction, normal, hit.fromInside ? object.index : 1. / object.index);
                    if (direction == vec3(0.)) mirrored = 1.;
                    else {
                        vec3 share = hit.fromInside ? vec3(1.) : object.glass * (object.pattern == kPlain ? object.color : paint);
                        stack[height++] = Pending(Ray(place - uOffset * normal, direction), now.weight * share, now.depth + 1);
                    }
                }
                mirrors = mirrored > 0.;
                if (mirrors)
                    now = Pending(Ray(place + uOffset * normal, reflect(now.ray.direction, normal)), now.weight * mirrored,
                                  now.depth + 1);
            }
#endif
        }
        more = mirrors;
#ifndef FIRST_HIT
        if (!mirrors && height > 0) {
            now = stack[--height];
            more = true;
        }
#endif
    }
    return color;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    ivec2 panelSize = max(size / uPanels, 1), panel = min(pixel / panelSize, uPanels - 1);
    // Panels count from the upper left.
    int depth = uDepths[panel.x + (uPanels.y - 1 - panel.y) * uPanels.x];
    vec3 color = trace(eyeRay(uEye, pixel - panel * panelSize, panelSize), depth);
    imageStore(uPicture, pixel, vec4(clamp(color, 0., 1.), 1.));
}
