// Raises the grid to one of three surfaces.
#version 330 core

uniform int uSurface;
uniform float uHeight;

out vec2 vXY;
out vec3 vPosition;   // eye space

float height(vec2 p) {
    if (uSurface == 0) return uHeight * sin(3. * p.x) * sin(3. * p.y);
    if (uSurface == 1) return uHeight * .25 * (p.x * p.x * p.x - 3. * p.x * p.y * p.y);
    return uHeight * 2. * cos(4. * dot(p, p)) * exp(-dot(p, p));
}

void main() {
    vXY = aVertex.xy;
    vec4 raised = vec4(vXY, height(vXY), 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
