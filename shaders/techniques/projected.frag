// R65 A dim room in which a projector shows its slide, in front of it only and not beyond the frame.
#version 330 core

uniform sampler2D uPicture;
uniform sampler2DShadow uDepth;
uniform mat4 view;
uniform vec3 uProjectorPlace, uPaint;
uniform float uBright;
uniform bool uShadows;

in vec4 vSlide;
in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    normal = faceforward(normal, vPosition, normal);
    vec3 toProjector = normalize(vec3(view * vec4(uProjectorPlace, 1.)) - vPosition);
    float ambient = .18 + .08 * normal.y;
    vec2 st = vSlide.st / vSlide.q;
    bool inFrame = vSlide.q > 0. && all(greaterThan(st, vec2(0.))) && all(lessThan(st, vec2(1.)));
    float free = uShadows ? textureProj(uDepth, vSlide - vec4(0., 0., .002 * vSlide.q, 0.)) : 1.;
    vec3 slide = inFrame ? free * textureProj(uPicture, vSlide.stq).rgb : vec3(0.);
    fColor = vec4(uPaint * (ambient + uBright * max(dot(normal, toProjector), 0.) * slide), 1.);
}
