// G16.5 to G16.9 Ray tracing with one mirrored ray: ball, turned box, checkered table, sky from a cube map, shadows.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "rays.glsl"

layout(rgba8) uniform writeonly image2D uPicture;
uniform samplerCube court;
uniform mat4 uBox;
uniform vec3 uEye, uLight;
uniform float uMirror, uOffset;

const vec3 kBall = vec3(1.1, .3, -2.), kBoxSides = vec3(.6, .9, .6);
const float kBallRadius = 1.7;
const vec3 kTable = vec3(0., -2.11, -2.);

const int kNothing = 0, kIsBall = 1, kIsBox = 2, kIsTable = 3;

Hit nearest(Ray ray, out int what) {
    what = kNothing;
    Hit best = kNoHit;
    Hit ball = hitSphere(ray, kBall, kBallRadius);
    if (ball.t < best.t) best = ball, what = kIsBall;
    Hit box = hitPlacedBox(ray, uBox, kBoxSides);
    if (box.t < best.t) best = box, what = kIsBox;
    Hit table = hitTable(ray, kTable, vec2(6., 4.));
    if (table.t < best.t) best = table, what = kIsTable;
    return best;
}

/// Bricks on a face of the box: its two other axes are the coordinates.
vec3 brickColor(vec3 place, vec3 normal) {
    vec3 p = transpose(mat3(uBox)) * (place - uBox[3].xyz), n = abs(transpose(mat3(uBox)) * normal);
    vec2 at = n.x > .5 ? p.zy : n.y > .5 ? p.xz : p.xy;
    at *= vec2(2.5, 5.);
    if (mod(floor(at.y), 2.) > .5) at.x += .5;
    vec2 inBrick = fract(at);
    return inBrick.x < .06 || inBrick.y < .12 ? vec3(.75, .73, .70) : vec3(.62, .22, .15);
}

vec3 surfaceColor(int what, vec3 place, vec3 normal) {
    if (what == kIsBall) return vec3(.55, .60, .65);
    if (what == kIsBox) return brickColor(place, normal);
    return mod(floor(2. * place.x) + floor(2. * place.z), 2.) < .5 ? vec3(.08) : vec3(.92);
}

vec3 lit(Ray ray, Hit hit, int what) {
    if (what == kNothing) return texture(court, ray.direction).rgb;
    vec3 place = ray.start + hit.t * ray.direction;
    vec3 toLight = normalize(uLight - place);
    vec3 color = .3 * surfaceColor(what, place, hit.normal);
    int blocker;
    Hit shadow = nearest(Ray(place + uOffset * hit.normal, toLight), blocker);
    if (shadow.t < distance(place, uLight)) return color;
    color += .8 * max(dot(hit.normal, toLight), 0.) * surfaceColor(what, place, hit.normal);
    return color + .5 * pow(max(dot(reflect(-toLight, hit.normal), -ray.direction), 0.), 50.);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    Ray ray = eyeRay(uEye, pixel, size);
    int what;
    Hit hit = nearest(ray, what);
    vec3 color = lit(ray, hit, what);
    if (what == kIsBall) {
        vec3 place = ray.start + hit.t * ray.direction;
        Ray mirrored = Ray(place + uOffset * hit.normal, reflect(ray.direction, hit.normal));
        int second;
        Hit inMirror = nearest(mirrored, second);
        color = mix(color, lit(mirrored, inMirror, second), uMirror);
    }
    imageStore(uPicture, pixel, vec4(min(color, 1.), 1.));
}
