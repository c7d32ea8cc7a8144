#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <optional>

namespace twintrace {

/// Where tasks of one user run, on as many threads as were asked for. An arena alone does not give
/// more threads than the machine has cores: TBB would cut the number and print a warning.
class ThreadArena {
 public:
  /// @param threads 0 = one per core
  explicit ThreadArena(int threads)
      : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {
    if (threads > tbb::info::default_concurrency()) {
      allowance_.emplace(tbb::global_control::max_allowed_parallelism,
                         static_cast<std::size_t>(threads));
    }
  }

  template <class Action>
  void execute(const Action& action) {
    arena_.execute(action);
  }

 private:
  std::optional<tbb::global_control> allowance_;
  tbb::task_arena arena_;
};

}  // namespace twintrace
