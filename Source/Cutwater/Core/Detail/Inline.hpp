#pragma once

// Arithmetic that public headers define inline is always inlined. A user's file may be compiled
// with -ffast-math or -march=native. If such a function were emitted there as a weak symbol, the
// linker could choose that copy for the library too, whose answers would then depend on the user's
// flags.
#if defined(__GNUC__) || defined(__clang__)
#define CUTWATER_INLINE [[gnu::always_inline]]
#else
#define CUTWATER_INLINE
#endif
