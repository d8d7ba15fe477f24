#include "suite/write_below.h"

#include <system_error>

#include "base/contained.h"
#include "image/file.h"

namespace glibra::suite {

Diagnostics writeBelow(const std::filesystem::path& folder, const std::filesystem::path& name,
                       std::span<const std::byte> bytes) {
    const int problem = base::writeBeneath(folder, name, bytes);
    return problem == 0 ? Diagnostics{} : Diagnostics{cannotWrite(folder / name, problem)};
}

Diagnostic cannotWrite(const std::filesystem::path& file, int problem) {
    return image::cannotWrite(file, std::generic_category().message(problem));
}

}  // namespace glibra::suite
