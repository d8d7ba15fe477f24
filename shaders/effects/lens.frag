// SH118 Lens: what the refracted line of sight meets, a little whitened, with a dark rim.
#version 330 core

uniform samplerCube uRefractUnit;

in vec3 vBent;
in vec2 vXY;

out vec4 fColor;

void main() {
    vec3 seen = textureCube(uRefractUnit, mat3(uModelViewMatrixInverse) * vBent).rgb;
    float rim = smoothstep(.955, .965, length(vXY));
    fColor = vec4(mix(mix(seen, vec3(1.), .12), vec3(.10, .11, .13), rim), 1.);
}
