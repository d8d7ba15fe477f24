#pragma once
// What `glibra info` prints. `glibra-bench precision` prints the same and adds to it.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gpu/context/context.h"

namespace glibra::cli {

/// Lines for a terminal, the version of glibra first.
std::string infoText(const gpu::Context& context);

/// The same as the text of a JSON object.
std::string infoJsonText(const gpu::Context& context);

/// The same as an object.
nlohmann::ordered_json infoJson(const gpu::Context& context);

}  // namespace glibra::cli
