// Draws the scene named by the first argument; succeeds if the picture has the size asked for and more than
// one colour.
#include <glibra/render.h>

#include <algorithm>
#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    auto renderer = glibra::Renderer::open();
    if (!renderer) return 4;
    glibra::RenderOptions options;
    options.width = 64;
    options.height = 48;
    const auto picture = renderer->render(argv[1], options);
    for (const glibra::Diagnostic& each : picture.diagnostics) std::puts(toString(each).c_str());
    if (!picture || picture->width != 64 || picture->height != 48) return 1;
    const auto [least, most] = std::minmax_element(picture->data.begin(), picture->data.end());
    return *least == *most ? 1 : 0;
}
