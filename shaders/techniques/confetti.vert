// R46 Confetti: a piece waits for its start, then flies on p = p0 + v t + g t^2 / 2 until it lies on the ground.
#version 330 core

uniform float uTime, uGravity, uSize;

in vec3 aStart, aVelocity;
in vec4 aPaint;
in float aBegin;

out vec4 vPaint;

void main() {
    float t = uTime - aBegin;
    vec3 place = aStart + aVelocity * t - vec3(0., .5 * uGravity * t * t, 0.);
    float lands = (aVelocity.y + sqrt(aVelocity.y * aVelocity.y + 2. * uGravity * aStart.y)) / uGravity;
    if (t > lands) place = aStart + aVelocity * lands - vec3(0., .5 * uGravity * lands * lands, 0.);
    vPaint = aPaint;
    gl_Position = t < 0. ? vec4(0., 0., 2., 1.) : uModelViewProjectionMatrix * vec4(place, 1.);   // 2: out of sight
    gl_PointSize = uSize / gl_Position.w;
}
