// R28 Überlight (Barzel 1997): a lamp whose pool is a superellipse with soft edges, which begins and ends in depth.
#version 330 core

uniform vec3 uLampPlace;             // eye space
uniform vec3 uLampColor, uPaint;
uniform float uIntensity, uAmbient;
uniform vec2 uShape;                 // half width and half height of the opening at the distance 1
uniform vec2 uShapeEdge;             // how far the soft edge goes beyond it
uniform float uRoundness;            // 0 a rectangle, 1 an ellipse
uniform vec4 uBarn;                  // how far the doors on the left, right, below, above are closed, 0 to 1
uniform float uNear, uFar, uNearEdge, uFarEdge;
uniform float uFalloff, uFalloffDistance, uMaxIntensity;
uniform bool uParallel;

in vec3 vInLamp;
in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

// 1 within the superellipse with half axes `inner`, 0 outside of `outer`, smooth between them.
float superellipse(vec2 p, vec2 inner, vec2 outer) {
    p = abs(p);
    float power = 2. / max(uRoundness, .02);
    if (max(p.x, p.y) < 1e-6) return 1.;
    // Along the ray through p, how far both outlines are: (|x|/a)^power + (|y|/b)^power = 1.
    vec2 a = p / inner, b = p / outer;
    float large = max(a.x, a.y), wide = max(b.x, b.y);
    float toInner = 1. / (large * pow(pow(a.x / large, power) + pow(a.y / large, power), 1. / power));
    float toOuter = 1. / (wide * pow(pow(b.x / wide, power) + pow(b.y / wide, power), 1. / power));
    return 1. - smoothstep(toInner, toOuter, 1.);
}

void main() {
    float depth = -vInLamp.z;
    vec2 across = uParallel ? vInLamp.xy : vInLamp.xy / max(depth, 1e-4);
    float pool = superellipse(across, uShape, uShape + uShapeEdge);
    vec2 low = mix(-uShape - uShapeEdge, vec2(0.), uBarn.xz), high = mix(uShape + uShapeEdge, vec2(0.), uBarn.yw);
    vec2 open = smoothstep(low - uBarn.xz * uShapeEdge, low + uBarn.xz * uShapeEdge + 1e-4, across)
        * (1. - smoothstep(high - uBarn.yw * uShapeEdge - 1e-4, high + uBarn.yw * uShapeEdge, across));
    float range = smoothstep(uNear - uNearEdge, uNear, depth) * (1. - smoothstep(uFar, uFar + uFarEdge, depth));
    float falloff = min(pow(uFalloffDistance / max(length(vInLamp), 1e-3), uFalloff), uMaxIntensity);
    float light = depth > 0. ? uIntensity * pool * open.x * open.y * range * falloff : 0.;

    vec3 normal = normalize(vNormal), toLamp = normalize(uLampPlace - vPosition);
    normal = faceforward(normal, vPosition, normal);
    float diffuse = max(dot(normal, toLamp), 0.);
    float shine = diffuse > 0. ? .3 * pow(max(dot(reflect(-toLamp, normal), normalize(-vPosition)), 0.), 30.) : 0.;
    fColor = vec4(uPaint * uAmbient + light * uLampColor * (uPaint * diffuse + shine), 1.);
}
