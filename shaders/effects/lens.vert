// SH117 Lens: the line of sight, refracted at the front and at the back. Both faces are spheres, and the
// lens is so thin that both lie in the disk. A face with a positive radius bulges outwards, with a negative one inwards.
#version 330 core

uniform float uR1;   // front
uniform float uR2;   // back

out vec3 vBent;   // eye space
out vec2 vXY;

const float kEta = .66;   // air to glass

// The outward normal of a face at a point of the disk, towards +z. A face of radius 0 is flat.
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
