// R22 A toy ball: the ray through the pixel meets a true sphere; its star is where at least four of five half-spaces hold.
#version 330 core

uniform mat4 uBall;          // from the ball to the eye, without scale
uniform vec3 uYellow, uRed, uBlue;
uniform float uStripe, uStar, uSmooth;

in vec3 vCorner;
out vec4 fColor;

void main() {
    vec3 ray = normalize(vCorner), centre = uBall[3].xyz;
    float along = dot(ray, centre);
    float under = 1. + along * along - dot(centre, centre);
    if (under < 0.) discard;
    vec3 normal = (along - sqrt(under)) * ray - centre;
    vec3 p = transpose(mat3(uBall)) * normal;   // on the ball itself

    // Both ends of the z axis carry a star.
    float held = 0.;
    for (int i = 0; i < 5; ++i) {
        float angle = radians(72. * float(i));
        float distance = uStar - dot(p.xy, vec2(sin(angle), cos(angle)));
        held += smoothstep(-uSmooth, uSmooth, distance);
    }
    float star = clamp(held - 3., 0., 1.);
    float stripe = 1. - smoothstep(uStripe - uSmooth, uStripe + uSmooth, abs(p.z));
    vec3 color = mix(mix(uYellow, uRed, star), uBlue, stripe);

    vec3 toLight = normalize(vec3(.6, 1., 1.2));
    float light = .25 + .75 * max(dot(normal, toLight), 0.);
    float shine = .6 * pow(max(dot(reflect(-toLight, normal), -ray), 0.), 40.);
    fColor = vec4(light * color + shine, 1.);
}
