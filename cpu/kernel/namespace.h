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
#define TWINTRACE_STEP __attribute__((noinline, flatten))
