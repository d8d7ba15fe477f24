// Gx16.5 Coloured glass: what shines through a ball and a box has the colour of one of them, or a mixture of both.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "modern/rays.glsl"
#include "mixing.glsl"

layout(rgba8) uniform writeonly image2D uPicture;
uniform vec4 uFirst, uSecond;  // colours of the ball and of the box
uniform float uIndex;
uniform mat4 uBox;

const vec3 kBall = vec3(-.7, 0., .3), kBoxSides = vec3(1., 1., .5), kLamp = vec3(-3., 4., 5.);
const float kRadius = 1.2;

/// A white wall with soft waves behind the glass.
vec3 wallColor(Ray ray) {
    vec3 place = ray.start + (-3. - ray.start.z) / min(ray.direction.z, -.05) * ray.direction;
    return vec3(.92 + .07 * sin(3. * place.x) * sin(3. * place.y));
}

/// The ray after it has passed an object that it meets.
Ray through(Ray ray, Hit hit, bool isBall) {
    vec3 place = ray.start + hit.t * ray.direction;
    Ray inside = Ray(place - .001 * hit.normal, refract(ray.direction, hit.normal, 1. / uIndex));
    Hit leave = isBall ? hitSphere(inside, kBall, kRadius) : hitPlacedBox(inside, uBox, kBoxSides);
    vec3 outside = refract(inside.direction, -leave.normal, uIndex);
    if (outside == vec3(0.)) outside = inside.direction;
    return Ray(inside.start + leave.t * inside.direction + .001 * leave.normal, outside);
}

float highlight(Ray ray, Hit hit) {
    vec3 toLamp = normalize(kLamp - ray.start - hit.t * ray.direction);
    return .7 * pow(max(dot(reflect(-toLamp, hit.normal), -ray.direction), 0.), 60.);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    // Four panels: mean and light above, ink and paint below.
    ivec2 panelSize = max(size / 2, 1), panel = min(pixel / panelSize, 1);
    int way = panel.x + 2 * (1 - panel.y);
    Ray ray = eyeRay(vec3(0., 0., 4.), pixel - panel * panelSize, panelSize);

    bool meetsBall = false, meetsBox = false;
    float shine = 0.;
    // The ball stands before the box.
    Hit ball = hitSphere(ray, kBall, kRadius);
    if (ball.t < kNone) {
        meetsBall = true;
        shine = highlight(ray, ball);
        ray = through(ray, ball, true);
    }
    Hit box = hitPlacedBox(ray, uBox, kBoxSides);
    if (box.t < kNone) {
        meetsBox = true;
        if (!meetsBall) shine = highlight(ray, box);
        ray = through(ray, box, false);
    }
    vec3 color = wallColor(ray);
    if (meetsBall && meetsBox) color *= mixed(uFirst.rgb, uSecond.rgb, way);
    else if (meetsBall) color *= uFirst.rgb;
    else if (meetsBox) color *= uSecond.rgb;
    imageStore(uPicture, pixel, vec4(min(color + shine, 1.), 1.));
}
