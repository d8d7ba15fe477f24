// G16.6 G16.7 Pictures on a ball and a box, and a sky box of six pictures with the light of a lamp or without.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "modern/rays.glsl"

layout(rgba8) uniform writeonly image2D uPicture;
uniform sampler2D uPlanet, uBricks;
uniform sampler2D uRight, uLeft, uTop, uBottom, uBack, uFront;  // of the sky box: +x -x +y -y +z -z
uniform vec3 uLight;
uniform mat4 uBox;
uniform bool uLitSky;

const float kTurn = 6.2831853;
const vec3 kBall = vec3(1.2, 0., -1.5), kBoxSides = vec3(.9, .9, .6), kSkySides = vec3(20.);
const float kRadius = 1.6;

/// Longitude and latitude of a place on a ball, from 0 to 1.
vec3 ballColor(vec3 normal) {
    vec2 place = vec2(.5 + atan(-normal.z, normal.x) / kTurn, .5 - asin(-normal.y) / (.5 * kTurn));
    return textureLod(uPlanet, place, 0.).rgb;
}

/// The two coordinates along a face, scaled so that the longest side of the box takes the whole picture.
vec3 boxColor(vec3 place, vec3 normal) {
    vec3 p = place / (2. * max(max(kBoxSides.x, kBoxSides.y), kBoxSides.z)) + .5, n = abs(normal);
    return textureLod(uBricks, n.x > .5 ? p.zy : n.y > .5 ? p.xz : p.xy, 0.).rgb;
}

/// The picture of the face that a place on the sky box lies on; `place` has the length 1 along the face's normal.
vec3 skyColor(vec3 place) {
    vec3 size = abs(place), p = .5 * place + .5, q = 1. - p;
    if (size.x >= max(size.y, size.z))
        return place.x > 0. ? textureLod(uRight, vec2(q.z, p.y), 0.).rgb : textureLod(uLeft, p.zy, 0.).rgb;
    if (size.y >= size.z)
        return place.y > 0. ? textureLod(uTop, vec2(p.x, q.z), 0.).rgb : textureLod(uBottom, p.xz, 0.).rgb;
    return place.z > 0. ? textureLod(uBack, p.xy, 0.).rgb : textureLod(uFront, vec2(q.x, p.y), 0.).rgb;
}

bool isShadowed(vec3 place, vec3 toLight) {
    Ray ray = Ray(place, toLight);
    return min(hitSphere(ray, kBall, kRadius).t, hitPlacedBox(ray, uBox, kBoxSides).t) < distance(place, uLight);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    Ray ray = eyeRay(vec3(0., 0., 5.), pixel, size);

    Hit hit = hitBox(ray, kSkySides);
    hit.normal = -hit.normal;
    vec3 surface = skyColor((ray.start + hit.t * ray.direction) / kSkySides);
    bool isSky = true;
    Hit ball = hitSphere(ray, kBall, kRadius);
    if (ball.t < hit.t) hit = ball, surface = ballColor(ball.normal), isSky = false;
    Hit box = hitPlacedBox(ray, uBox, kBoxSides);
    if (box.t < hit.t) {
        hit = box;
        mat3 turn = mat3(uBox);
        surface = boxColor((ray.start + hit.t * ray.direction - uBox[3].xyz) * turn, hit.normal * turn);
        isSky = false;
    }

    vec3 color = surface;
    if (!isSky || uLitSky) {
        vec3 place = ray.start + hit.t * ray.direction, toLight = normalize(uLight - place);
        float diffuse = max(dot(hit.normal, toLight), 0.), specular = 0.;
        if (isShadowed(place + .001 * hit.normal, toLight)) diffuse = 0.;
        else if (!isSky) specular = pow(max(dot(reflect(-toLight, hit.normal), -ray.direction), 0.), 50.);
        color = (.3 + .7 * diffuse) * surface + .5 * specular;
    }
    imageStore(uPicture, pixel, vec4(min(color, 1.), 1.));
}
