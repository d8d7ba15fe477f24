// Laptops with two graphics cards let a program draw with the fast one if it exports these names. Only the
// file of a program counts, not a library, and a static library would lose them because nobody refers to
// them: so this file belongs to the sources of each program (add_executable), as does glibra.rc.

extern "C" {
__declspec(dllexport) extern const unsigned long NvOptimusEnablement = 1;
__declspec(dllexport) extern const int AmdPowerXpressRequestHighPerformance = 1;
}
