#include "image/module_loader.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <new>
#include <system_error>

#include "image/convert.h"
#include "image/module/abi.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

struct Module {
    GlibraReadPicture read = nullptr;
    GlibraWritePicture write = nullptr;
};

template <class Function>
Function functionOf(void* library, const char* name) {
    return reinterpret_cast<Function>(::dlsym(library, name));
}

/// Loading a library that is already loaded takes microseconds, so nothing is cached here. The library is
/// never unloaded: OpenImageIO does not survive that.
std::optional<Module> loadModule(std::span<const fs::path> folders) {
    for (const fs::path& folder : folders) {
        const fs::path file = folder / "glibra_openimageio.so";
        std::error_code failed;
        if (!fs::exists(file, failed)) continue;
        void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        if (library == nullptr) continue;
        const auto version = functionOf<GlibraModuleVersion>(library, "glibraModuleVersion");
        const Module module{functionOf<GlibraReadPicture>(library, "glibraReadPicture"),
                            functionOf<GlibraWritePicture>(library, "glibraWritePicture")};
        if (version != nullptr && version() == kGlibraModuleVersion && module.read != nullptr &&
            module.write != nullptr)
            return module;
    }
    return std::nullopt;
}

Diagnostic notInstalled(Format format, const FileLabel& label) {
    return diagnose("file-E03",
                    fmt::format("'{}' is {}, but the image module that reads it is not installed", label.name,
                                describe(format)),
                    label.place);
}

/// The results of the module's callback.
struct Reception {
    Image image;
    const Limits& limits;
    const FileLabel& label;
    std::optional<Diagnostic> refusal;
};

/// No exception may pass through the module, so a lack of memory rejects the picture like any other problem.
void* receive(void* context, std::uint64_t width, std::uint64_t height, int type) {
    auto& reception = *static_cast<Reception*>(context);
    Image& image = reception.image;
    image.type = type == kGlibraU8 ? Component::u8 : type == kGlibraU16 ? Component::u16 : Component::f32;
    try {
        reception.refusal =
            checkSize(width, height, 4 * bytesOf(image.type), reception.limits, reception.label);
        if (reception.refusal) return nullptr;
        image.width = static_cast<int>(width);
        image.height = static_cast<int>(height);
        image.data.resize(image.rowBytes() * static_cast<std::size_t>(height));
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    return image.data.data();
}

}  // namespace

std::vector<fs::path> defaultModuleFolders() {
    std::vector<fs::path> folders;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed && program.has_parent_path()) {
        folders.push_back(program.parent_path());
        folders.push_back(program.parent_path().parent_path() / "lib" / "glibra");
    }
#ifdef GLIBRA_MODULE_BUILD_DIR  // the build defines both if it builds the module
    folders.emplace_back(GLIBRA_MODULE_INSTALL_DIR);
    folders.emplace_back(GLIBRA_MODULE_BUILD_DIR);
#endif
    return folders;
}

Result<Image> readByModule(Format format, std::span<const std::byte> file, const fs::path& path,
                           const FileLabel& label, const Limits& limits,
                           std::span<const fs::path> moduleFolders) {
    const auto module = loadModule(moduleFolders);
    if (!module) return notInstalled(format, label);

    Reception reception{{}, limits, label, std::nullopt};
    std::array<char, 500> message{};
    const std::string formatName(openImageIoName(format));
    GlibraReadRequest request{};
    request.format = formatName.c_str();
    request.path = path.empty() ? nullptr : path.c_str();
    request.bytes = file.data();
    request.size = file.size();
    request.allocate = receive;
    request.context = &reception;
    request.message = message.data();
    request.messageSize = message.size();
    const int result = module->read(&request);
    if (result == kGlibraDone) return std::move(reception.image);
    if (reception.refusal) return *std::move(reception.refusal);
    if (result == kGlibraRefused) return damaged(label, "there is not enough memory to read it");
    return damaged(label, fmt::format("damaged or short file ({})", message.data()));
}

Diagnostics writeByModule(const Image& image, Format format, const fs::path& path, const FileLabel& label,
                          const std::string& comment, std::span<const fs::path> moduleFolders) {
    const auto module = loadModule(moduleFolders);
    if (!module) return {notInstalled(format, label)};

    const bool grey = image.components < 3;
    const Image colors = grey ? withComponents(image, image.components == 2 ? 4 : 3) : Image();
    const Image& source = grey ? colors : image;
    std::array<char, 500> message{};
    const std::string formatName(openImageIoName(format));
    GlibraWriteRequest request{};
    request.format = formatName.c_str();
    request.path = path.c_str();
    request.width = source.width;
    request.height = source.height;
    request.components = source.components;
    request.type = source.type == Component::u8    ? kGlibraU8
                   : source.type == Component::u16 ? kGlibraU16
                                                   : kGlibraF32;
    request.pixels = source.data.data();
    request.comment = comment.c_str();
    request.message = message.data();
    request.messageSize = message.size();
    if (module->write(&request) == kGlibraDone) return {};
    return {
        diagnose("file-E10", fmt::format("cannot write '{}': {}", label.name, message.data()), label.place)};
}

}  // namespace glibra::image
