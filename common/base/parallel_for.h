#pragma once

#include <tbb/parallel_for.h>

#include <utility>

#if defined(__SANITIZE_THREAD__)
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace twintrace {

/// Tells the thread sanitizer what TBB guarantees, since it can't see into the library: tasks see
/// what was written before their loop, and what they wrote is seen after it. Says nothing about two
/// tasks, so races between them are still found. Without the sanitizer it does nothing.
class TaskFence {
 public:
  void beforeLoop() { release(&begin_); }
  void taskBegins() { acquire(&begin_); }
  void taskEnds() { release(&end_); }
  void afterLoop() { acquire(&end_); }

 private:
#if defined(__SANITIZE_THREAD__)
  static void acquire(char* address) { __tsan_acquire(address); }
  static void release(char* address) { __tsan_release(address); }
#else
  static void acquire(char*) {}
  static void release(char*) {}
#endif

  char begin_ = 0;  // only their addresses count
  char end_ = 0;
};

#if defined(__SANITIZE_THREAD__)
#define TWINTRACE_UNSANITIZED __attribute__((no_sanitize("thread")))
#else
#define TWINTRACE_UNSANITIZED
#endif

/// What TBB calls for each part of a range. TBB hands the part and this object on in its tasks, which
/// the sanitizer can't see, so reading them is left out; the body then works on a copy of its own.
template <class Range, class Body>
class FencedBody {
 public:
  FencedBody(TaskFence& fence, const Body& body) : fence_(&fence), body_(&body) {}

  TWINTRACE_UNSANITIZED void operator()(const Range& part) const {
    const Range own = part;
    run(*fence_, *body_, own);
  }

 private:
  static void run(TaskFence& fence, const Body& body, const Range& part) {
    fence.taskBegins();
    body(part);
    fence.taskEnds();
  }

  TaskFence* fence_;
  const Body* body_;
};

/// tbb::parallel_for over a range, with a fence around it and its tasks.
/// @param body called with parts of the range, on many threads at once.
template <class Range, class Body, class... Partitioner>
void parallelFor(const Range& range, const Body& body, Partitioner&&... partitioner) {
  TaskFence fence;
  fence.beforeLoop();
  tbb::parallel_for(range, FencedBody<Range, Body>(fence, body),
                    std::forward<Partitioner>(partitioner)...);
  fence.afterLoop();
}

}  // namespace twintrace
