// R31 What is seen, as data: colour and normal.
#version 330 core

uniform vec3 uPaint;

in vec3 vNormal;
layout(location = 0) out vec4 fPaint;
layout(location = 1) out vec4 fNormal;

void main() {
    fPaint = vec4(uPaint, 1.);
    fNormal = vec4(normalize(vNormal), 1.);
}
