// Any bytes as a suite file, and as a line of a list of accepted hashes.

#include "check.h"
#include "suite/file/suite_file.h"
#include "suite/golden/hash_list.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    const std::string_view text = fuzz::textOf(data, size);
    const Result<suite::Suite> read = suite::readSuiteText(text, "nowhere/suite.toml");
    fuzz::checkMessages(read.diagnostics);
    fuzz::check(read.value.has_value() != hasError(read.diagnostics), "a suite or an error");
    const Result<suite::AcceptedHash> line = suite::parseLine(text.substr(0, text.find('\n')), {});
    if (line) {
        const Result<suite::AcceptedHash> again = suite::parseLine(suite::toLine(*line), {});
        fuzz::check(again && suite::toLine(*again) == suite::toLine(*line),
                    "a line is read as it was written");
    }
    return 0;
}
