// Noise as a volume: a ray through the cube collects mist where the noise is high, or stops at the isosurface.
#version 330 core

uniform bool uSurface;
uniform float uIsovalue;     // of the sum of the octaves, whose middle is 2
uniform float uNoiseScale;
uniform float uDensity;
uniform int uSteps;

in vec3 vModel;
in vec3 vEye;

out vec4 fColor;

float sumAt(vec3 place) {
    vec4 octaves = texture(Noise3, uNoiseScale * place + .37);
    return octaves.r + octaves.g + octaves.b + octaves.a;
}

vec3 slopeAt(vec3 place) {
    const vec2 e = vec2(.02, 0.);
    return vec3(sumAt(place + e.xyy) - sumAt(place - e.xyy), sumAt(place + e.yxy) - sumAt(place - e.yxy),
                sumAt(place + e.yyx) - sumAt(place - e.yyx));
}

vec3 lit(vec3 color, vec3 normal) {
    return color * (.3 + .7 * max(dot(normal, normalize(vec3(.5, .8, .6))), 0.));
}

void main() {
    vec3 ray = normalize(vModel - vEye);
    // The cube is -1..1; the ray enters at vModel, on a front face.
    vec3 ends = (sign(ray) - vModel) / ray;
    float leave = min(min(ends.x, ends.y), ends.z);
    float step = leave / float(uSteps);

    vec3 color = vec3(.10, .11, .14);
    if (uSurface) {
        float before = sumAt(vModel) - uIsovalue;
        if (before > 0.) {
            vec3 side = step == 0. ? vec3(0., 0., 1.) : vec3(greaterThan(abs(vModel), vec3(.9999))) * sign(vModel);
            fColor = vec4(lit(vec3(.75, .45, .30), side), 1.);
            return;
        }
        for (int i = 1; i <= uSteps; ++i) {
            vec3 place = vModel + step * float(i) * ray;
            float now = sumAt(place) - uIsovalue;
            if (now > 0.) {
                place -= step * now / (now - before) * ray;
                color = lit(vec3(.95, .70, .40), -normalize(slopeAt(place)));
                break;
            }
            before = now;
        }
    } else {
        float through = 1.;      // of the light behind
        vec3 sum = vec3(0.);
        for (int i = 0; i < uSteps; ++i) {
            float noise = sumAt(vModel + step * (float(i) + .5) * ray) - uIsovalue;
            float absorbed = 1. - exp(-uDensity * step * max(noise, 0.));
            sum += through * absorbed * mix(vec3(.45, .65, .95), vec3(1., .95, .8), clamp(6. * noise, 0., 1.));
            through *= 1. - absorbed;
        }
        color = sum + through * color;
    }
    fColor = vec4(color, 1.);
}
