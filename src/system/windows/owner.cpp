// To whom files belong, and who may use them.

#include <array>

#include "system/windows/win.h"

#include <aclapi.h>
#include <sddl.h>

namespace glibra::system {
namespace {

/// A part of what the system knows of the user of this process, as Part, which begins in `bytes`.
template <class Part>
struct OfUser {
    explicit OfUser(TOKEN_INFORMATION_CLASS which) {
        HANDLE token = nullptr;
        if (!::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &token)) return;
        const File open = ownOf(token);
        DWORD size = 0;
        isKnown = ::GetTokenInformation(token, which, bytes.data(), static_cast<DWORD>(bytes.size()), &size);
    }
    [[nodiscard]] const Part* part() const {
        return isKnown ? reinterpret_cast<const Part*>(bytes.data()) : nullptr;
    }
    alignas(Part) std::array<std::byte, sizeof(Part) + SECURITY_MAX_SID_SIZE> bytes{};
    bool isKnown = false;
};

/// The list of a file, which LocalFree() gives back; null if there is none.
struct AccessOf {
    AccessOf(HANDLE file, SECURITY_INFORMATION what) {
        if (::GetSecurityInfo(file, SE_FILE_OBJECT, what, &owner, nullptr, &list, nullptr, &descriptor) !=
            ERROR_SUCCESS)
            descriptor = nullptr;
    }
    AccessOf(const AccessOf&) = delete;
    AccessOf& operator=(const AccessOf&) = delete;
    ~AccessOf() { ::LocalFree(descriptor); }
    PSID owner = nullptr;
    PACL list = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
};

}  // namespace

bool isOwn(HANDLE file) {
    static const OfUser<TOKEN_USER> user(TokenUser);
    static const OfUser<TOKEN_OWNER> maker(TokenOwner);  // for an administrator it may be their group
    const AccessOf access(file, OWNER_SECURITY_INFORMATION);
    if (access.descriptor == nullptr || access.owner == nullptr) return false;
    return (user.part() != nullptr && ::EqualSid(access.owner, user.part()->User.Sid)) ||
           (maker.part() != nullptr && ::EqualSid(access.owner, maker.part()->Owner));
}

void copyAccessList(HANDLE from, HANDLE to) {
    const AccessOf access(from, DACL_SECURITY_INFORMATION);
    SECURITY_DESCRIPTOR_CONTROL control = 0;
    DWORD revision = 0;
    if (access.descriptor == nullptr || access.list == nullptr ||
        !::GetSecurityDescriptorControl(access.descriptor, &control, &revision))
        return;
    // The entries that the old file has inherited are made again from the folder.
    const SECURITY_INFORMATION inheriting = (control & SE_DACL_PROTECTED) != 0
                                                ? PROTECTED_DACL_SECURITY_INFORMATION
                                                : UNPROTECTED_DACL_SECURITY_INFORMATION;
    ::SetSecurityInfo(to, SE_FILE_OBJECT, DACL_SECURITY_INFORMATION | inheriting, nullptr, nullptr,
                      access.list, nullptr);
}

PrivateAccess::PrivateAccess() {
    const OfUser<TOKEN_USER> user(TokenUser);
    wchar_t* name = nullptr;
    if (user.part() == nullptr || !::ConvertSidToStringSidW(user.part()->User.Sid, &name)) return;
    // Nothing from the folder above; all rights for the user and for the system, also below.
    const std::wstring text = std::wstring(L"D:P(A;OICI;FA;;;") + name + L")(A;OICI;FA;;;SY)";
    ::LocalFree(name);
    if (!::ConvertStringSecurityDescriptorToSecurityDescriptorW(text.c_str(), SDDL_REVISION_1, &list_,
                                                                nullptr))
        list_ = nullptr;
    attributes_ = {sizeof attributes_, list_, FALSE};
}

PrivateAccess::~PrivateAccess() {
    ::LocalFree(list_);
}

}  // namespace glibra::system
