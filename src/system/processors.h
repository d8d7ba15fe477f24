#pragma once
// GLIBRA_FOR_EACH_PROCESSOR("default", "avx2"): before a function, which the compiler then generates for
// several kinds of processor; the loader of the system selects the best one. All give the same bits if no
// operations are fused. Where compiler or loader cannot do that, there is the first one only.

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GLIBRA_FOR_EACH_PROCESSOR(...) [[gnu::target_clones(__VA_ARGS__)]]
#else
#define GLIBRA_FOR_EACH_PROCESSOR(...)
#endif
