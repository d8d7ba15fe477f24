// A fragment of a list: its colour, its depth, and the number of the next one. 0 ends the list.

struct Node {
    vec4 color;
    float depth;
    uint next;
};
