// Snow finder: three pictures on three units; what is cold but has a clear sky above it is coloured green.
#version 330 core

uniform sampler2D uVisibleUnit, uInfraRedUnit, uWaterVaporUnit;
uniform float uInfraRedThreshold;     // colder than this
uniform float uWaterVaporThreshold;   // and drier than this, which is brighter

in vec2 vST;

out vec4 fColor;

void main() {
    // The large picture on the left two thirds, the three inputs on the right.
    if (vST.s > 2. / 3.) {
        vec2 place = vec2(3. * vST.s - 2., fract(3. * vST.t));
        int which = int(3. * vST.t);
        vec3 value = which == 2 ? texture(uVisibleUnit, place).rgb
                     : which == 1 ? texture(uInfraRedUnit, place).rgb * vec3(1., .75, .6)
                                  : texture(uWaterVaporUnit, place).rgb * vec3(.65, .8, 1.);
        fColor = vec4(value, 1.);
        return;
    }
    vec2 place = vec2(1.5 * vST.s, vST.t);
    vec3 color = texture(uVisibleUnit, place).rgb;
    float infraRed = texture(uInfraRedUnit, place).r;
    float vapour = texture(uWaterVaporUnit, place).r;
    if (infraRed < uInfraRedThreshold && vapour > uWaterVaporThreshold) color = vec3(0., 1., 0.);
    fColor = vec4(color, 1.);
}
