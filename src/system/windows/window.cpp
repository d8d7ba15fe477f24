#include "system/window.h"

#include <string>

#include "system/library.h"
#include "system/windows/win.h"

namespace glibra::system {

void setTitleBars(bool dark) {
    using Set = HRESULT(WINAPI*)(HWND, DWORD, const void*, DWORD);
    struct Request {
        Set set;
        BOOL dark;
    };
    std::string why;
    const Request request{
        Library::open("dwmapi.dll", Library::When::whenCalled, why).find<Set>("DwmSetWindowAttribute"),
        dark ? TRUE : FALSE};
    if (request.set == nullptr) return;
    ::EnumThreadWindows(
        ::GetCurrentThreadId(),
        [](HWND window, LPARAM data) -> BOOL {
            constexpr DWORD kImmersiveDarkMode = 20;  // and 19 before Windows 10 20H1
            const auto& [set, isDark] = *reinterpret_cast<const Request*>(data);
            if (set(window, kImmersiveDarkMode, &isDark, sizeof isDark) < 0)
                set(window, kImmersiveDarkMode - 1, &isDark, sizeof isDark);
            return TRUE;
        },
        reinterpret_cast<LPARAM>(&request));
}

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
