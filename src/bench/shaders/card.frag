// A plane in perspective, or a surface seen from the front. uView: start, texels, is a plane.
in vec2 vPlace;
uniform sampler2D uCard;
uniform vec4 uView;
out vec4 fColor;
void main() {
    float depth = 1. / (1.1 - vPlace.y);
    vec2 place = uView.w > 0. ? vec2((vPlace.x - .5) * depth, depth) : vPlace;
    fColor = texture(uCard, (uView.xy + uView.z * place) / 512.);
}
