// A scene in a texture that two contexts of SDL share: the library draws in one, the program in the other,
// whose state it leaves alone.
//   sdl SCENE.glib [FRAMES]
#define GL_GLEXT_PROTOTYPES
#include <SDL2/SDL.h>
#include <SDL2/SDL_opengl.h>
#include <glibra/glibra.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc < 2 || SDL_Init(SDL_INIT_VIDEO) != 0) return 2;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 1);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    constexpr int kWidth = 480, kHeight = 360;
    SDL_Window* window = SDL_CreateWindow("Shared", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, kWidth,
                                          kHeight, SDL_WINDOW_OPENGL);
    SDL_GLContext own = window != nullptr ? SDL_GL_CreateContext(window) : nullptr;
    SDL_GL_SetAttribute(SDL_GL_SHARE_WITH_CURRENT_CONTEXT, 1);
    SDL_GLContext shared = own != nullptr ? SDL_GL_CreateContext(window) : nullptr;  // is current now
    if (shared == nullptr) return std::fputs("no window with OpenGL 4.1\n", stderr), 4;

    glibra::Result<glibra::Renderer> renderer = glibra::Renderer::open(glibra::Renderer::current());
    if (!renderer) return std::fprintf(stderr, "%s\n", renderer.message().c_str()), 4;
    glibra::Result<glibra::Scene> scene = renderer->load(argv[1]);
    if (!scene) return std::fprintf(stderr, "%s\n", scene.message().c_str()), 3;

    SDL_GL_MakeCurrent(window, own);
    GLuint picture = 0, framebuffer = 0;
    glGenTextures(1, &picture);
    glBindTexture(GL_TEXTURE_2D, picture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 320, 240, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0);

    long left = argc > 2 ? std::atol(argv[2]) : -1;
    for (bool isOpen = true; left != 0 && isOpen; --left) {
        SDL_GL_MakeCurrent(window, shared);
        const auto drawn = scene->drawInto({.texture = picture}, {.time = SDL_GetTicks() / 1000.0});
        if (!drawn) return std::fprintf(stderr, "%s\n", drawn.message().c_str()), 3;
        glFinish();  // before another context reads it; a fence (glFenceSync) waits less

        SDL_GL_MakeCurrent(window, own);
        glClearColor(.3f, .1f, .2f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glBlitFramebuffer(0, 0, 320, 240, 20, 20, kWidth - 20, kHeight - 20, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        SDL_GL_SwapWindow(window);
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) isOpen = isOpen && event.type != SDL_QUIT;
    }
    SDL_Quit();
}
