#include "classroom/given_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "base/files.h"
#include "image/file.h"

namespace glibra::classroom {

Result<std::string> givenText(const std::filesystem::path& file, std::uint64_t largest) {
    if (std::error_code failure; std::filesystem::is_fifo(file, failure)) {
        std::ifstream pipe(file, std::ios::binary);
        std::string text(largest + 1, '\0');
        pipe.read(text.data(), static_cast<std::streamsize>(text.size()));
        text.resize(static_cast<std::size_t>(pipe.gcount()));
        if (text.size() > largest)
            return diagnose("file-E09", fmt::format("'{}' is longer than {} bytes", file.string(), largest));
        return text;
    }
    const auto bytes = image::readFile(file, {file.string(), {}}, largest);
    if (!bytes) return bytes.diagnostics;
    return std::string(base::asText(*bytes));
}

}  // namespace glibra::classroom
