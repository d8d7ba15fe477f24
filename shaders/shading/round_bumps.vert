// Round bumps: a sphere raised by bells around the corners of a grid in its texture, with the true normal of each vertex.
#version 330 core

uniform float uNumber;   // of bumps from pole to pole; twice as many around
uniform float uHeight;

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

const float kPi = 3.14159265;

// The height over the sphere, which vanishes toward the poles.
float raised(vec2 st) {
    float bump = .25 * (1. - cos(4. * kPi * uNumber * st.s)) * (1. - cos(2. * kPi * uNumber * st.t));
    return uHeight * bump * pow(sin(kPi * st.t), 2.);
}

vec3 place(vec2 st) {
    float longitude = 2. * kPi * st.s, latitude = kPi * (st.t - .5);
    vec3 outwards = vec3(-cos(longitude) * cos(latitude), sin(latitude), sin(longitude) * cos(latitude));
    return (1. + raised(st)) * outwards;
}

void main() {
    vec2 st = vec2(aTexCoord0.s, aTexCoord0.t);
    // The slopes from differences; near the poles the normal of the sphere.
    const float e = .001;
    vec3 normal = aNormal;
    if (abs(aNormal.y) < .995)
        normal = normalize(cross(place(st + vec2(e, 0.)) - place(st - vec2(e, 0.)), place(st + vec2(0., e)) - place(st - vec2(0., e))));
    if (dot(normal, aNormal) < 0.) normal = -normal;
    vec4 model = vec4((1. + raised(st)) * aNormal, 1.);

    vPosition = vec3(uModelViewMatrix * model);
    vNormal = uNormalMatrix * normal;
    gl_Position = uModelViewProjectionMatrix * model;
}
