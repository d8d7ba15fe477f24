// D20 SH104 Isosurface: the first step that crosses the value, refined by bisection.
#version 330 core

uniform sampler3D uTexUnit;
uniform int uNumSteps;   // along the diagonal of the volume
uniform float uValue;
uniform vec3 uColor;

in vec3 vModel;
in vec3 vSight;

out vec4 fColor;

float above(vec3 stp) {
    return texture(uTexUnit, stp).r - uValue;
}

void main() {
    vec3 step = normalize(vSight) * sqrt(3.) / float(max(uNumSteps, 1));
    vec3 stp = (vModel + 1.) / 2. + 1e-4 * step;
    float before = above(stp);
    for (int i = 0; i < uNumSteps; ++i) {
        vec3 next = stp + step;
        if (any(lessThan(next, vec3(0.))) || any(greaterThan(next, vec3(1.)))) break;
        float here = above(next);
        if (before * here < 0.) {
            vec3 low = stp, high = next;
            for (int j = 0; j < 10; ++j) {
                vec3 middle = .5 * (low + high);
                if (before * above(middle) < 0.) high = middle; else low = middle;
            }
            // The field's texels are 1/32 apart; differences over two of them keep the normals smooth.
            vec2 h = vec2(1. / 32., 0.);
            vec3 gradient = vec3(above(low + h.xyy) - above(low - h.xyy), above(low + h.yxy) - above(low - h.yxy),
                                 above(low + h.yyx) - above(low - h.yyx));
            vec3 normal = normalize(uNormalMatrix * -gradient);
            vec3 sight = normalize(mat3(uModelViewMatrix) * vSight);
            if (dot(normal, sight) > 0.) normal = -normal;
            vec3 toLight = normalize(vec3(-.5, .7, .6));
            float shine = pow(max(dot(reflect(-toLight, normal), -sight), 0.), 40.);
            fColor = vec4((.25 + .75 * max(dot(normal, toLight), 0.)) * uColor + .5 * shine, 1.);
            return;
        }
        stp = next;
        before = here;
    }
    discard;
}
