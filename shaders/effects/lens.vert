// SH117 Lens: the line of sight, bent at the front and at the back; both faces are spheres, and the
// lens is so thin that both lie in the disk. A radius above 0 bulges outwards, below 0 inwards.
#version 330 core

uniform float uR1;   // front
uniform float uR2;   // back

out vec3 vBent;   // eye space
out vec2 vXY;

const float kEta = .66;   // air to glass

// The outward normal of a face at the disk's point, towards +z; flat for radius 0.
vec3 faceNormal(vec2 xy, float radius) {
    if (abs(radius) < 1e-3) return vec3(0., 0., 1.);
    vec2 slope = xy / radius;
    return normalize(vec3(slope, sqrt(max(1. - dot(slope, slope), 0.))));
}

void main() {
    vec3 sight = normalize(vec3(uModelViewMatrix * aVertex));
    vec3 front = normalize(uNormalMatrix * faceNormal(aVertex.xy, uR1));
    vec3 backOutwards = faceNormal(aVertex.xy, uR2) * vec3(1., 1., -1.);
    vec3 back = normalize(uNormalMatrix * backOutwards);

    vec3 inGlass = refract(sight, front, kEta);
    vec3 bent = refract(inGlass, -back, 1. / kEta);
    vBent = bent == vec3(0.) ? reflect(inGlass, -back) : bent;   // total reflection
    vXY = aVertex.xy;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
