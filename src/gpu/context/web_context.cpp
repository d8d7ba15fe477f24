// The context of a page's canvas: WebGL 2. Its functions are imports of the module (page/web/gl.js), which
// the page maps.

#include <glad/gl.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "gpu/context/context.h"

extern "C" {

/// True if the page's WebGL has a function.
[[clang::import_module("gl"), clang::import_name("has")]] bool glibra_has(const char* function);

#define GLIBRA_ES_FUNCTION(name)  \
    [[clang::import_module("gl"), \
      clang::import_name(         \
          "gl" #name)]] extern std::remove_pointer_t<decltype(glad_gl##name)> glibra_gl##name;
#include "gpu/context/es_functions.def"
#define GLIBRA_ES_FUNCTION(name)  \
    [[clang::import_module("gl"), \
      clang::import_name(         \
          "gl" #name)]] extern std::remove_pointer_t<decltype(glad_gl##name)> glibra_gl##name;
GLIBRA_ES_FUNCTION(GetBufferSubData)
#undef GLIBRA_ES_FUNCTION
}

namespace glibra::gpu {
namespace {

struct Function {
    std::string_view name;
    void* address;
};

#define GLIBRA_ES_FUNCTION(name) {"gl" #name, reinterpret_cast<void*>(&glibra_gl##name)},
const Function kFunctions[] = {
#include "gpu/context/es_functions.def"
    {"glGetBufferSubData", reinterpret_cast<void*>(&glibra_glGetBufferSubData)}};

class CanvasBackend final : public Backend {
  public:
    bool makeCurrent() override { return true; }
    [[nodiscard]] bool isCurrent() const override { return true; }
    void* address(const char* function) override {
        for (const Function& each : kFunctions)
            if (each.name == function) return glibra_has(function) ? each.address : nullptr;
        return nullptr;
    }
    [[nodiscard]] Driver driver() const override { return Driver::gles; }
    [[nodiscard]] std::string description() const override { return "WebGL 2 of the page"; }
};

Attempt openCanvas(const ContextOptions& /*options*/) {
    return std::make_unique<CanvasBackend>();
}

constexpr ContextWay kWays[] = {{Driver::gles, openCanvas}};

}  // namespace

std::span<const ContextWay> contextWays() {
    return kWays;
}

bool loadCoreFunctions(Backend& /*backend*/) {
    return false;
}

std::string_view adviceWithoutDriver() {
    return "Switch on hardware acceleration in the settings of the browser, or use one that has WebGL 2";
}

}  // namespace glibra::gpu
