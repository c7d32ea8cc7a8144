#pragma once

// The kernel's text is compiled once per instruction set. An inline namespace per build keeps the
// linker from merging a function that was compiled for AVX-512 with its baseline copy.
#ifndef TWINTRACE_KERNEL_BUILD
#define TWINTRACE_KERNEL_BUILD baseline
#endif

#define TWINTRACE_KERNEL_BEGIN    \
  namespace twintrace::kernel {   \
  inline namespace TWINTRACE_KERNEL_BUILD {
#define TWINTRACE_KERNEL_END \
  }                          \
  }

// A step of a path: one function with everything that it calls inlined, since records of wide numbers
// are slow to pass, but apart from the other integrators', whose common stack frame would be huge.
// With a sanitizer's checks inside, g++ takes many minutes for such a function.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TWINTRACE_INLINE inline
#define TWINTRACE_STEP __attribute__((noinline))
#else
#define TWINTRACE_INLINE __attribute__((always_inline)) inline
#define TWINTRACE_STEP __attribute__((noinline, flatten))
#endif
