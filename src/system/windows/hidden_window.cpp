#include "system/hidden_window.h"

#include "system/windows/win.h"

namespace glibra::system {
namespace {

constexpr wchar_t kClass[] = L"glibra hidden window";

/// Each window of this class has its device context for itself, for as long as it lives.
bool hasClass() {
    static const bool isMade = [] {
        WNDCLASSEXW kind{};
        kind.cbSize = sizeof kind;
        kind.style = CS_OWNDC;
        kind.lpfnWndProc = ::DefWindowProcW;
        kind.hInstance = ::GetModuleHandleW(nullptr);
        kind.lpszClassName = kClass;
        return ::RegisterClassExW(&kind) != 0;
    }();
    return isMade;
}

bool setFormat(HDC context) {
    constexpr BYTE kColour = 32, kAlpha = 8, kDepth = 24;
    PIXELFORMATDESCRIPTOR wanted{};
    wanted.nSize = sizeof wanted;
    wanted.nVersion = 1;
    wanted.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    wanted.iPixelType = PFD_TYPE_RGBA;
    wanted.cColorBits = kColour;
    wanted.cAlphaBits = kAlpha;
    wanted.cDepthBits = kDepth;
    const int format = ::ChoosePixelFormat(context, &wanted);
    if (format == 0 || !::SetPixelFormat(context, format, &wanted)) return false;
    PIXELFORMATDESCRIPTOR got{};
    ::DescribePixelFormat(context, format, sizeof got, &got);
    return (got.dwFlags & PFD_GENERIC_FORMAT) == 0;  // else it is that of Windows itself, OpenGL 1.1
}

}  // namespace

HiddenWindow::HiddenWindow() {
    if (!hasClass()) return;
    const HWND window = ::CreateWindowExW(0, kClass, L"", WS_POPUP, 0, 0, 1, 1, nullptr, nullptr,
                                          ::GetModuleHandleW(nullptr), nullptr);
    window_ = window;
    const HDC context = window == nullptr ? nullptr : ::GetDC(window);
    if (context != nullptr && setFormat(context)) context_ = context;
}

HiddenWindow::~HiddenWindow() {
    if (window_ != nullptr) ::DestroyWindow(static_cast<HWND>(window_));
}

}  // namespace glibra::system
