#include "editor/front_end.h"

#include <array>
#include <cstdio>
#include <memory>

#include "system/process.h"

namespace glibra::editor {
namespace {

struct CloseStream {
    void operator()(std::FILE* each) const { std::fclose(each); }
};

}  // namespace

std::string frontEndLog(glsl::Stage stage, const std::string& source) {
    constexpr std::array kStages{"vert", "tesc", "tese", "geom", "frag", "comp"};
    if (system::findInPath("glslangValidator").empty()) return {};
    const std::unique_ptr<std::FILE, CloseStream> input(std::tmpfile()), output(std::tmpfile());
    if (!input || !output) return {};
    if (std::fwrite(source.data(), 1, source.size(), input.get()) != source.size() ||
        std::fseek(input.get(), 0, SEEK_SET) != 0)
        return {};
    system::Process process = system::startProgram(
        {"glslangValidator", "--stdin", "-S", kStages.at(static_cast<std::size_t>(stage))},
        {input.get(), output.get(), system::Stream::To::nothing});
    if (!process || waitFor(process).isGood() || std::fseek(output.get(), 0, SEEK_SET) != 0) return {};
    std::string log;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), output.get())) > 0;)
        log.append(buffer.data(), count);
    return log;
}

}  // namespace glibra::editor
