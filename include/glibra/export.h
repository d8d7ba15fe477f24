#pragma once

/// Marks what the shared library exports. Everything else is hidden.
#if !defined(_WIN32)
#define GLIBRA_API __attribute__((visibility("default")))
#elif defined(GLIBRA_EXPORTS)
#define GLIBRA_API __declspec(dllexport)
#else
#define GLIBRA_API  // functions of an import library need no mark
#endif
