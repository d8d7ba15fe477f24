// SH121 Glory: 180 degrees less the angle to the point opposite the sun, from 180 (the middle) to 160, looks up the colours of the rings.
#version 330 core

uniform sampler2D uImageUnit;
uniform sampler2D uGloryUnit;
uniform float uUpDown, uLeftRight;   // the point opposite the sun, in the picture
uniform float uInOut;                // distance from the eye to the picture
uniform float uRadius;               // angle of the outermost ring, degrees
uniform float uMix;
uniform bool uByCloud;

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

void main() {
    vec3 cloud = texture(uImageUnit, vST).rgb;
    vec2 offset = vXY - vec2(uLeftRight, uUpDown);
    float angle = 180. - degrees(atan(length(offset), uInOut));
    vec3 color = cloud;
    if (angle > 160.) {
        float v = min((180. - angle) / uRadius, .99);
        vec4 glory = texture(uGloryUnit, vec2(v, .5));
        float amount = uMix * glory.a;
        if (uByCloud) amount *= smoothstep(.35, .85, dot(cloud, vec3(.30, .59, .11)));
        color = mix(cloud, cloud * (.35 + .9 * glory.rgb), amount);
    }
    // The shadow of the airplane: fuselage, wings and tail.
    vec2 p = abs(offset) * vec2(1., 1.);
    float body = max(p.x / .016, p.y / .11), wing = max(p.x / .12, abs(offset.y - .01 + .25 * p.x) / .018),
          tail = max(p.x / .045, abs(offset.y + .09 + .2 * p.x) / .012);
    color *= mix(.45, 1., smoothstep(.7, 1.3, min(body, min(wing, tail))));
    fColor = vec4(color, 1.);
}
