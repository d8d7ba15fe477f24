// G16.12 G16.13 Ray tracing without recursion. A ray brings its colour home with a weight, the product of what it met
// before; so the sum over all rays is the picture, and the stack holds rays that still have to be followed.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "rays.glsl"
#include "noise.glsl"

layout(rgba8) uniform writeonly image2D uPicture;
uniform int uDepth;
uniform vec3 uLight;
uniform float uIndex;  // refractive index of the glass

const int kRoom = 0, kBall = 1, kBlock = 2, kTable = 3;

struct Object {
    int type;
    vec3 center, size;
    vec3 color;
    float reflectivity, refractivity;  // what remains is the colour of the surface itself
};

const Object kObjects[] = Object[](
    Object(kRoom, vec3(0.), vec3(10., 6., 10.), vec3(.45, .62, .82), 0., 0.),
    Object(kTable, vec3(0., -2.4, -1.5), vec3(6., 0., 5.), vec3(1.), 0., 0.),
    Object(kBlock, vec3(-2.4, -1.3, -3.2), vec3(.6, 1.1, .6), vec3(.9), .1, 0.),
    Object(kBall, vec3(.4, -1.1, -4.), vec3(1.3), vec3(.9, .75, .4), .75, 0.),
    Object(kBall, vec3(1.2, -1.4, -.3), vec3(1.), vec3(.85, .95, .9), .1, .85));

struct Pending {
    Ray ray;
    vec3 weight;
    int depth;
};
// Each ray that is taken off leaves two at most, one level deeper, so uDepth + 1 places would do.
Pending stack[16];

Hit hitObject(Ray ray, Object object) {
    if (object.type == kBall) return hitSphere(ray, object.center, object.size.x);
    if (object.type == kTable) return hitTable(ray, object.center, object.size.xz);
    Hit hit = hitBox(Ray(ray.start - object.center, ray.direction), object.size);
    // The eye is inside of the room: its normals point inward.
    if (object.type == kRoom) hit.normal = -hit.normal, hit.fromInside = false;
    return hit;
}

Hit nearest(Ray ray, out int which) {
    Hit best = kNoHit;
    which = 0;
    for (int i = 0; i < kObjects.length(); ++i) {
        Hit hit = hitObject(ray, kObjects[i]);
        if (hit.t < best.t) best = hit, which = i;
    }
    return best;
}

/// How much light reaches a place: glass lets a part of it through.
float lightAt(vec3 place, vec3 toLight) {
    Ray ray = Ray(place, toLight);
    float light = 1.;
    for (int i = 1; i < kObjects.length(); ++i)
        if (hitObject(ray, kObjects[i]).t < distance(place, uLight)) light *= .8 * kObjects[i].refractivity;
    return light;
}

vec3 surfaceColor(Object object, vec3 place) {
    if (object.type == kTable) return mod(floor(place.x) + floor(place.z), 2.) < .5 ? vec3(.06) : vec3(.94);
    if (object.type == kBlock) {
        float vein = abs(sin(4. * (place.x + place.y + place.z) + 4. * fractalNoise(1.5 * place, 4)));
        return mix(vec3(.20, .24, .34), object.color, pow(vein, .6));
    }
    return object.color;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;

    vec3 color = vec3(0.);
    int height = 0;
    stack[height++] = Pending(eyeRay(vec3(0., .3, 5.5), pixel, size), vec3(1.), 0);
    while (height > 0) {
        --height;
        Ray ray = stack[height].ray;
        vec3 weight = stack[height].weight;
        int depth = stack[height].depth;

        int which;
        Hit hit = nearest(ray, which);
        if (hit.t == kNone) continue;
        Object object = kObjects[which];
        vec3 place = ray.start + hit.t * ray.direction;
        vec3 normal = hit.fromInside ? -hit.normal : hit.normal;  // toward the ray

        // The surface's own light: ambient, diffuse, and a highlight.
        vec3 toLight = normalize(uLight - place);
        float light = lightAt(place + .001 * normal, toLight);
        vec3 own = (.3 + .7 * light * max(dot(normal, toLight), 0.)) * surfaceColor(object, place);
        bool isDull = object.type == kRoom || object.type == kTable || hit.fromInside;
        float highlight = isDull ? 0. : light * pow(max(dot(reflect(-toLight, normal), -ray.direction), 0.), 60.);
        float share = 1. - object.reflectivity - object.refractivity;
        color += weight * (share * own + .6 * highlight);

        if (depth == uDepth) continue;
        float mirrored = object.reflectivity;
        if (object.refractivity > 0.) {
            vec3 direction = refract(ray.direction, normal, hit.fromInside ? uIndex : 1. / uIndex);
            if (direction == vec3(0.)) mirrored += object.refractivity;  // total reflection
            else {
                Ray refracted = Ray(place - .001 * normal, direction);
                stack[height++] = Pending(refracted, weight * object.refractivity, depth + 1);
            }
        }
        // Metal colours what it mirrors; glass and polished stone do not.
        vec3 tint = object.refractivity == 0. && object.type == kBall ? object.color : vec3(1.);
        if (mirrored > 0.) {
            Ray reflected = Ray(place + .001 * normal, reflect(ray.direction, normal));
            stack[height++] = Pending(reflected, weight * mirrored * tint, depth + 1);
        }
    }
    imageStore(uPicture, pixel, vec4(min(color, 1.), 1.));
}
