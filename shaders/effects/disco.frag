// SH123 Disco ball, the room: a place is bright if a mirror of the ball reflects the lamp to it. The normal of such a
// mirror lies half way between lamp and place; it has to be close to the middle of one of the mirrors.
#version 330 core

uniform int uNum;   // mirrors from pole to pole
uniform vec3 uColor, uSpotColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kBall = vec3(0., 1.45, -4.4);   // eye space
const vec3 kLamp = vec3(2., 0., 0.);       // from the ball, eye space
const float kPi = 3.14159265;

// The normal of the mirror that contains `direction`, on a ball rotated by `turn`.
vec3 mirrorNormal(vec3 direction, float turn) {
    float step = kPi / float(uNum);
    float latitude = asin(clamp(direction.y, -1., 1.));
    float row = (floor(latitude / step) + .5) * step;
    float around = max(cos(row) * float(2 * uNum), 1.);   // fewer mirrors near the poles
    float column = 2. * kPi / floor(around);
    float longitude = dot(direction.xz, direction.xz) > 0. ? atan(direction.x, direction.z) : 0.;
    float middle = (floor((longitude - turn) / column) + .5) * column + turn;
    return vec3(cos(row) * sin(middle), sin(row), cos(row) * cos(middle));
}

void main() {
    vec3 fromBall = normalize(vPosition - kBall);
    vec3 toLamp = normalize(kLamp);
    vec3 wanted = normalize(fromBall + toLamp);
    vec3 mirror = mirrorNormal(wanted, 2. * kPi * Timer);
    float closeness = max(dot(reflect(-toLamp, mirror), fromBall), 0.);
    float facing = abs(dot(normalize(vNormal), fromBall));
    float spot = closeness > .98 ? pow(closeness, 5000.) * (.3 + .7 * facing) : 0.;

    float dim = .10 + .22 * abs(dot(normalize(vNormal), normalize(vec3(.3, .6, 1.))));
    fColor = vec4(dim * uColor + 1.2 * spot * uSpotColor, 1.);
}
