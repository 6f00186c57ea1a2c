#pragma once

// Arithmetic that public headers define inline is always inlined. A user's file may be compiled
// with -ffast-math or -march=native; were such a function emitted there as a weak symbol, the
// linker could pick that copy for the library too, and the library's answers would change with the
// user's flags.
#if defined(__GNUC__) || defined(__clang__)
#define CUTWATER_INLINE [[gnu::always_inline]]
#else
#define CUTWATER_INLINE
#endif
