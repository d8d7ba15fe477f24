// From a place in a panorama to a direction, and back: s = 1/2 + atan(z, x) / 2 pi, t = acos(y) / pi.
const float kPi = 3.14159265;

vec3 directionAt(vec2 st) {
    float around = 2. * kPi * (st.s - .5), down = kPi * st.t;
    return vec3(cos(around) * sin(down), cos(down), sin(around) * sin(down));
}

vec2 placeOf(vec3 direction) {
    vec3 d = normalize(direction);
    return vec2(.5 + atan(d.z, d.x) / (2. * kPi), acos(clamp(d.y, -1., 1.)) / kPi);
}
