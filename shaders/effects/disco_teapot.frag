// D24 Disco inside the teapot: as disco.frag, with the ball in the middle of the pot and a wider spot.
#version 330 core

uniform int uNum;      // mirrors from pole to pole
uniform float uTurn;   // radians
uniform bool uBall;
uniform vec3 uColor, uSpotColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kBall = vec3(0., .22, 0.);
const vec3 kToLamp = normalize(vec3(1., -.25, .4));
const float kPi = 3.14159265;

// The normal of the mirror that contains `direction`; xy of `inMirror` are the place in it, -.5 to .5.
vec3 mirrorNormal(vec3 direction, out vec2 inMirror) {
    float step = kPi / float(uNum);
    float latitude = asin(clamp(direction.y, -1., 1.)) / step;
    float row = (floor(latitude) + .5) * step;
    float column = 2. * kPi / floor(max(cos(row) * float(2 * uNum), 1.));
    float longitude = dot(direction.xz, direction.xz) > 0. ? atan(direction.x, direction.z) : 0.;
    float across = (longitude - uTurn) / column;
    inMirror = fract(vec2(across, latitude)) - .5;
    float middle = (floor(across) + .5) * column + uTurn;
    return vec3(cos(row) * sin(middle), sin(row), cos(row) * cos(middle));
}

void main() {
    vec2 inMirror;
    vec3 fromBall = normalize(vPosition - kBall);
    if (uBall) {
        vec3 mirror = mirrorNormal(fromBall, inMirror);
        float bright = .25 + .6 * max(dot(mirror, normalize(vec3(-.6, .1, .5))), 0.) + .5 * pow(max(dot(mirror, kToLamp), 0.), 8.);
        bool joint = max(abs(inMirror.x), abs(inMirror.y)) > .43;
        fColor = vec4(joint ? vec3(.05) : bright * uColor, 1.);
        return;
    }
    vec3 mirror = mirrorNormal(normalize(fromBall + kToLamp), inMirror);
    float closeness = max(dot(reflect(-kToLamp, mirror), fromBall), 0.);
    float spot = smoothstep(.9985, .9993, closeness) * float(dot(mirror, kToLamp) > .05);
    float facing = abs(dot(normalize(vNormal), fromBall));
    fColor = vec4((.10 + .30 * facing) * uColor + .9 * spot * (.4 + .6 * facing) * uSpotColor, 1.);
}
