// EX11.18 Break-through by a stored map: the new picture where the map is below uT.
#version 330 core

uniform float uT;
uniform sampler2D uBeforeUnit, uAfterUnit, uMapUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    bool after = texture(uMapUnit, vST).r < uT;
    fColor = vec4(after ? texture(uAfterUnit, vST).rgb : texture(uBeforeUnit, vST).rgb, 1.);
}
