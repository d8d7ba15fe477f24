// Cubic Bezier curves divided in two at t = 1/2 (de Casteljau), as long as they are not straight enough. A stack stands for the
// recursion: the right half waits there while the left half is looked at.

uniform vec2 uPoints[4];
uniform float uTolerance;

const int kLevels = 6;      // no piece is shorter than 1/64

struct Curve {
    vec2 p0, p1, p2, p3;
    int level;
};

bool isStraight(Curve c) {
    float legs = distance(c.p0, c.p1) + distance(c.p1, c.p2) + distance(c.p2, c.p3);
    return legs - distance(c.p0, c.p3) < uTolerance || c.level == kLevels;
}

void halves(Curve c, out Curve left, out Curve right) {
    vec2 middle = (c.p1 + c.p2) / 2.;
    left.p0 = c.p0;
    left.p1 = (c.p0 + c.p1) / 2.;
    left.p2 = (left.p1 + middle) / 2.;
    right.p3 = c.p3;
    right.p2 = (c.p2 + c.p3) / 2.;
    right.p1 = (right.p2 + middle) / 2.;
    left.p3 = right.p0 = (left.p2 + right.p1) / 2.;
    left.level = right.level = c.level + 1;
}
