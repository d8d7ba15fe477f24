// SH123 Disco ball, the ball itself: mirrors of different brightness with dark joints, rotating with time.
#version 330 core

uniform int uNum;   // mirrors from pole to pole

in vec3 vNormal;

out vec4 fColor;

const float kPi = 3.14159265;

void main() {
    vec3 direction = normalize(vNormal);
    float step = kPi / float(uNum);
    float latitude = asin(clamp(direction.y, -1., 1.)) / step;
    float row = (floor(latitude) + .5) * step;
    float column = 2. * kPi / floor(max(cos(row) * float(2 * uNum), 1.));
    float longitude = dot(direction.xz, direction.xz) > 0. ? atan(direction.x, direction.z) : 0.;
    float across = (longitude - 2. * kPi * Timer) / column;
    vec2 inMirror = abs(fract(vec2(across, latitude)) - .5);
    if (max(inMirror.x, inMirror.y) > .45) {
        fColor = vec4(.05, .05, .06, 1.);
        return;
    }
    float turned = (floor(across) + .5) * column + 2. * kPi * Timer;
    vec3 mirror = vec3(cos(row) * sin(turned), sin(row), cos(row) * cos(turned));
    // What a mirror shows of a room with a bright stripe at lamp height.
    vec3 seen = reflect(vec3(0., 0., -1.), mirror);
    float bright = .25 + .5 * smoothstep(-.3, .9, seen.y) + .9 * pow(max(dot(seen, normalize(vec3(.9, .1, .5))), 0.), 12.);
    fColor = vec4(bright * vec3(.85, .88, 1.), 1.);
}
