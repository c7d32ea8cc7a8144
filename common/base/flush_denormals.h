#pragma once

#include <immintrin.h>

namespace twintrace {

/// Sets flush-to-zero and denormals-are-zero on this thread for a scope, as GPUs and llvmpipe do.
/// Threads started meanwhile inherit it.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace twintrace
