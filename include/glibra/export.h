#pragma once

/// Marks what the shared library exports. Everything else is hidden.
#if defined(_WIN32)
#define GLIBRA_API
#else
#define GLIBRA_API __attribute__((visibility("default")))
#endif
