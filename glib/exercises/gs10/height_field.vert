// A flat square. Exercise: raise it by noise.
#version 330 core

uniform int uOctaves;        // 1 to 4
uniform float uHeight;
uniform float uNoiseScale;

out float vNoise;     // about -.5 to .5
out vec3 vPosition;   // eye space

void main() {
    vNoise = min(float(uOctaves) * uHeight * uNoiseScale, 0.);   // Change this line, which only keeps the uniforms in use.
    vec4 raised = vec4(aVertex.xy, 0., 1.);                      // And this one.
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
