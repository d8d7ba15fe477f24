// SH111 Streamtube arrow: x of the arrow becomes the way along a helix; y and z become its normal and binormal.
#version 330 core

uniform float uN;            // turns
uniform float uK;            // height of the helix
uniform float uPeristaltic;  // growth of the radius in the bulge
uniform float uSpeed;        // of the bulge, arrow lengths per timer period
uniform float uPhase;        // where the bulge is at time 0

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

const float kTwoPi = 6.2831853;
const float kRadius = 2.;      // of the helix
const float kThickness = 2.4;  // of the tube, relative to that of the arrow
const float kHeadShare = .04;
const float kHalfBulge = .1;

void main() {
    // 0..1 along the helix: the shaft, x = -1..6/10, takes all but the last part, so that the head is not stretched.
    bool onHead = aVertex.x > .6;
    float tSlope = onHead ? kHeadShare / .4 : (1. - kHeadShare) / 1.6;   // d t / d x
    float t = onHead ? 1. - (1. - aVertex.x) * tSlope : (aVertex.x + 1.) * tSlope;
    float turn = kTwoPi * uN;          // d angle / d t
    float c = cos(turn * t), s = sin(turn * t);

    // The helix around y, and its Frenet frame.
    vec3 point = vec3(kRadius * c, uK * t, kRadius * s);
    vec3 velocity = vec3(-kRadius * turn * s, uK, kRadius * turn * c);
    float speed = length(velocity);
    vec3 tangent = velocity / speed;
    vec3 normal = vec3(-c, 0., -s);
    vec3 binormal = cross(tangent, normal);
    float curvature = kRadius * turn * turn / (speed * speed);
    float torsion = -uK * turn / (speed * speed);

    // The bulge: a cosine bell, 0 with slope 0 at its ends.
    float fromBulge = t - fract(uPhase + uSpeed * Timer);
    bool inside = abs(fromBulge) < kHalfBulge;
    float angle = kTwoPi / 2. * fromBulge / kHalfBulge;
    float grow = kThickness * (1. + (inside ? uPeristaltic * .5 * (1. + cos(angle)) : 0.));
    float growSlope = inside ? -kThickness * uPeristaltic * .5 * sin(angle) * kTwoPi / 2. / kHalfBulge : 0.;

    float y = aVertex.y, z = aVertex.z;
    vec3 place = point + grow * (y * normal + z * binormal);

    // The columns of the derivative of the deformation. Their cross products transform a normal with the surface.
    vec3 alongT = speed * (tangent + grow * (y * (torsion * binormal - curvature * tangent) - z * torsion * normal)) +
                  growSlope * (y * normal + z * binormal);
    vec3 alongX = tSlope * alongT, alongY = grow * normal, alongZ = grow * binormal;
    vec3 bent = aNormal.x * cross(alongY, alongZ) + aNormal.y * cross(alongZ, alongX) +
                aNormal.z * cross(alongX, alongY);

    vPosition = vec3(uModelViewMatrix * vec4(place, 1.));
    vNormal = uNormalMatrix * bent;
    gl_Position = uModelViewProjectionMatrix * vec4(place, 1.);
}
