#include "system/title_bar.h"

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

}  // namespace glibra::system
