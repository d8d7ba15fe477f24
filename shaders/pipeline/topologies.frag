// G4.s10 Topologies: a colour for each primitive by its number; faces of the other winding are darker.
#version 410 core

uniform bool uWhite;

out vec4 fColor;

const vec3 kColors[6] = vec3[](vec3(.93, .42, .34), vec3(.96, .75, .30), vec3(.46, .78, .42),
                               vec3(.33, .70, .86), vec3(.48, .50, .93), vec3(.85, .45, .80));

void main() {
    vec3 color = uWhite ? vec3(1.) : kColors[gl_PrimitiveID % 6];
    fColor = vec4((gl_FrontFacing ? 1. : .6) * color, 1.);
}
